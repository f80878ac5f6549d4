#pragma once

#include <string_view>

namespace displayfile {

/// What the command and the programs may ask for: `exact`, or `roundoff` with ROUNDOFF as a
/// part of the scene's size.
struct Precision {
  static constexpr double kUsualRoundoff = 1e-9;
  bool exact = true;
  double roundoff = kUsualRoundoff;
  /// Whether both find the same: what is exact has no use for its roundoff.
  bool operator==(const Precision& o) const {
    return exact == o.exact && (exact || roundoff == o.roundoff);
  }
};

/// Reads `exact`, `roundoff` or `roundoff=EPS`; throws Error for anything else, and unless
/// 0 <= EPS < 1.
Precision precision(std::string_view text);

}  // namespace displayfile
