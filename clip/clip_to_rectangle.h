#pragma once

#include <utility>
#include <vector>

#include "clip/view.h"

namespace displayfile {

/// Sutherland and Hodgman's four stages for a polygon that is drawn already, where there are no
/// planes left but the sides of a rectangle: for devices that take no points far outside of the
/// page. Point is Point2 or Point3; where a side crosses the rectangle's, all coordinates run
/// linearly. (ClipPipeline does more: homogeneous points, sides that are not drawn, and the same
/// cut for polygons that share a side.) `spare` keeps its memory from one polygon to the next.
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

}  // namespace displayfile
