#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "clip/surfaces.h"
#include "hidden/lines/lines_on_lines.h"

namespace displayfile {

/// A piece of a line to draw, in device coordinates.
struct StrokeOfPicture {
  LineOfPicture line;
  std::uint32_t rank = 0;   ///< of overlapping strokes the lowest is drawn
  std::uint32_t group = 0;  ///< equal for strokes with the same attributes; different groups are
                            ///< drawn over each other
  bool is_entered = false;  ///< a whole line as entered by the application: never a crumb
  bool is_hidden = false;   ///< hidden but drawn: never a crumb, and joins none
};

/// The drawn part of a stroke: from and to are fractions of it.
struct StrokePart {
  std::uint32_t stroke;
  double from, to;
  /// True if it joins no visible stroke: it is a crumb if it is shorter than the pen is wide.
  bool is_alone;
  LineCuts cuts = {};  ///< the ends at which a nearer stroke cuts it
  bool is_whole() const { return from == 0.0 && to == 1.0; }
  /// The point at a fraction of the stroke from `start` to `end`.
  static Point3 at(const Point3& start, const Point3& end, double share) {
    if (share == 0.0) return start;
    return share == 1.0 ? end : start + share * (end - start);
  }
};

/// Draws each position once (hidden/lines/strokes_once.md): where several strokes of a group
/// overlap, within `apart`, one is drawn. An uncovered stroke is whole. By stroke, from.
std::vector<StrokePart> strokes_once(std::span<const StrokeOfPicture> strokes,
                                     double apart = kLinesApart);

/// True if a stroke from one point to the other is shorter than its pen is wide. `pixels` is the
/// picture's size in the units of that width; 0: never.
bool is_shorter_than_wide(const Point2& from, const Point2& to, const Point2& pixels, double width);

}  // namespace displayfile
