#pragma once

#include <algorithm>
#include <span>

#include "clip/point.h"

namespace displayfile {

/// A rectangle, in doubles: of the view plane (window), of normalised device coordinates
/// (viewport), or around a polygon in the projection. (clip/bounds.h has boxes in space.)
struct Rectangle {
  double x_min, x_max, y_min, y_max;
  bool operator==(const Rectangle&) const = default;
};

/// The rectangle around one point or more in the projection, for the minimax test; exact.
/// (hidden/extents.h has boxes in space, rounded outward.)
inline Rectangle bounding_rectangle(std::span<const Point3> vertices) {
  Rectangle r{vertices[0].x, vertices[0].x, vertices[0].y, vertices[0].y};
  for (const Point3& v : vertices) {
    r.x_min = std::min(r.x_min, v.x);
    r.x_max = std::max(r.x_max, v.x);
    r.y_min = std::min(r.y_min, v.y);
    r.y_max = std::max(r.y_max, v.y);
  }
  return r;
}

}  // namespace displayfile
