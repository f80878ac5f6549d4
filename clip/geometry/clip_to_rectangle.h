#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "clip/geometry/rectangle.h"

namespace displayfile {

/// Sutherland and Hodgman's four stages for a polygon in the picture, against the sides of a
/// rectangle, for devices that accept no points far outside of the page. Point is Point2 or Point3;
/// all coordinates are interpolated linearly where a side crosses. (ClipPipeline does more:
/// homogeneous points, undrawn sides, and equal cuts of shared sides.) `spare` keeps its memory
/// between calls. The rectangle is not empty, and coordinates are finite.
template <class Point>
void clip_to_rectangle(std::vector<Point>& polygon, std::vector<Point>& spare,
                       const Rectangle& rectangle) {
  const auto clip = [&](int axis, double limit, double inward) {
    if (polygon.empty()) return;
    spare.clear();
    Point from = polygon.back();
    double from_inside = inward * (from[axis] - limit);
    for (const Point& to : polygon) {
      const double inside = inward * (to[axis] - limit);
      if ((from_inside < 0.0) != (inside < 0.0)) {
        Point crossing = from + (from_inside / (from_inside - inside)) * (to - from);
        crossing[axis] = limit;
        spare.push_back(crossing);
      }
      if (inside >= 0.0) spare.push_back(to);
      from = to;
      from_inside = inside;
    }
    std::swap(polygon, spare);
  };
  clip(0, rectangle.x_min, 1.0);
  clip(0, rectangle.x_max, -1.0);
  clip(1, rectangle.y_min, 1.0);
  clip(1, rectangle.y_max, -1.0);
}

/// A part of a line: 0 is the line's start and 1 its end.
struct LinePart {
  double from = 0.0, to = 1.0;
};

/// The part in the rectangle of a part of the line from `start` to `end`, which must be finite;
/// none if it is outside. Liang and Barsky, "A new concept and method for line clipping", ACM TOG 3
/// (1984).
template <class Point>
std::optional<LinePart> part_in_rectangle(const Point& start, const Point& end,
                                          const Rectangle& rectangle, LinePart part = {}) {
  const std::array low{rectangle.x_min, rectangle.y_min};
  const std::array high{rectangle.x_max, rectangle.y_max};
  for (int axis = 0; axis < 2; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    for (const double inward : {1.0, -1.0}) {
      const double limit = inward > 0.0 ? low[k] : high[k];
      const double inside = inward * (start[axis] - limit);
      const double change = inward * (end[axis] - start[axis]);
      if (change == 0.0 && inside < 0.0) return std::nullopt;
      if (change > 0.0) part.from = std::max(part.from, -inside / change);
      if (change < 0.0) part.to = std::min(part.to, -inside / change);
    }
  }
  if (!(part.from <= part.to)) return std::nullopt;
  return part;
}

}  // namespace displayfile
