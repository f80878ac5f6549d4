#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"

namespace displayfile::bench {

/// Thrown by draw_anew: the method cannot draw this display file, with the reason.
struct CannotDraw {
  std::string why;
};

/// One display file, to be drawn any number of times by one method at one size.
class Drawing {
 public:
  virtual ~Drawing() = default;
  /// A picture from the display file, with nothing kept from earlier ones. A peer is warm, and its
  /// input is already in its own form: it passes that on, and draws.
  virtual void draw_anew() = 0;
  /// Draws the picture again, with all that the last drawing left; after draw_anew.
  virtual void draw_again() { draw_anew(); }
  /// Draws the picture again with the item buffer and the depths; after draw_anew.
  virtual Picture judged() = 0;
  /// Polygons and lines before and after a sort or the map; after judged.
  struct Pieces {
    std::uint64_t of, made;
  };
  virtual std::optional<Pieces> pieces() const { return std::nullopt; }
};

/// A picture's size in pixels, and the number of threads that draw it.
struct Frame {
  int width, height, threads = 1;
};

/// A method at one precision.
struct Contender {
  std::string method;     ///< the name on the command line, or that of a peer
  std::string precision;  ///< "exact", "roundoff=1e-06", or a depth format
  bool exact;             ///< claims that no pixel is wrong
  bool threaded;          ///< can use several threads here
  bool counted;           ///< its memory comes from operator new, its predicates are ours
  /// Makes the drawing of a display file that lives on.
  std::function<std::unique_ptr<Drawing>(const DisplayFile&, const Frame&)> draw;

  std::string name() const { return precision.empty() ? method : method + ", " + precision; }
};

/// The methods that find polygons in object space, without pixels: the sorts return pieces of all
/// polygons in an order, the map the visible ones, none of which overlaps another.
inline constexpr std::array kObjectSpaceMethods{HiddenMethod::bsp, HiddenMethod::depth_sort,
                                                HiddenMethod::map};
bool is_in_object_space(std::string_view method);

/// "exact", or "roundoff=1e-6".
std::string name_of_precision(const Precision& precision);

/// All that this build has: the heedless painter; the choice of `auto` for a picture; the
/// image-space methods and the sorts, exact and with each ROUNDOFF; the map; the plain z-buffer and
/// OSMesa at each of their depth formats; Embree and gl2ps.
std::vector<Contender> contenders(std::span<const double> roundoffs);

/// The unit of all times: the exact z-buffer on one thread.
Contender reference_contender();
inline constexpr const char* kReference = "z-buffer, exact, 1 thread";

}  // namespace displayfile::bench
