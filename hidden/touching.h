#pragma once

#include <string>
#include <string_view>

namespace displayfile {

/// Within which distance parts of a scene touch: their *reach* (interp/truth/entered_truth.md).
/// Files and decimals say less exactly than they mean, so that what is meant to touch lies a few
/// units of its last digit apart.
struct Touching {
  enum class Kind {
    automatic,  ///< by the precision of the input's numbers
    off,        ///< nothing touches but what coincides exactly
    length,     ///< within that length
  };
  Kind kind = Kind::automatic;
  double length = 0.0;  ///< in the coordinates of the input, before its modelling transformation

  bool operator==(const Touching&) const = default;
};

/// By what part of the largest a number may be off, as it is rounded.
inline constexpr double kUnitOfDoubles = 0x1p-52, kUnitOfSingles = 0x1p-24;

/// The reach before the modelling transformation. `largest` is the largest magnitude of a
/// coordinate that was entered, of polygons and lines; `unit` is that of these numbers.
double entered_reach(const Touching& touching, double largest, double unit = kUnitOfDoubles);
/// What holds unless it is set.
inline constexpr Touching kUnlessSet{Touching::Kind::automatic};

/// Throws Error unless a length is above 0 and at most kCoordinateLimit.
void require_touching(const Touching& touching);
/// As `touching` reads it.
std::string word_of(const Touching& touching);

/// `auto`, `off` or a positive number up to kCoordinateLimit; throws Error for anything else.
Touching touching(std::string_view word);

}  // namespace displayfile
