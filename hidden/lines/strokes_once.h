#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/lines/lines_on_lines.h"

namespace displayfile {

/// A piece of a line that is to be drawn, in device coordinates.
struct StrokeOfPicture {
  LineOfPicture line;
  std::uint32_t rank = 0;   ///< where strokes lie on each other the lowest is drawn
  std::uint32_t group = 0;  ///< those that look alike; others are drawn over each other
  bool is_entered = false;  ///< the whole of a line that the application entered: it is no crumb
  bool is_hidden = false;   ///< and drawn nevertheless: it is no crumb, and joins none
};

/// The drawn part of a stroke: from and to are shares of it.
struct StrokePart {
  std::uint32_t stroke;
  double from, to;
  /// No end of another stroke that is seen is where one of its ends is: it is a crumb if it is
  /// shorter than the pen is wide.
  bool is_alone;
  bool is_whole() const { return from == 0.0 && to == 1.0; }
  /// The point at a share of the stroke, which runs from the one to the other.
  static Point3 at(const Point3& start, const Point3& end, double share) {
    if (share == 0.0) return start;
    return share == 1.0 ? end : start + share * (end - start);
  }
};

/// Strokes as a draughtsman draws them (hidden/lines/strokes_once.md): where several of a group lie
/// on each other, within `apart`, each place is drawn by one. A stroke that nothing covers is
/// whole. By stroke, from.
std::vector<StrokePart> strokes_once(std::span<const StrokeOfPicture> strokes,
                                     double apart = kLinesApart);

/// True if a stroke from one point to the other is shorter than a pen is wide. `pixels` is the
/// picture's size in the units of that width; 0: none is.
bool is_shorter_than_wide(const Point2& from, const Point2& to, const Point2& pixels, double width);

}  // namespace displayfile
