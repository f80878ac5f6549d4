#pragma once

#include <algorithm>
#include <span>

#include "clip/point.h"

namespace displayfile {

/// The box around a polygon in the projection, for the minimax test; exact. (hidden/extents.h has
/// boxes in space, rounded outward.)
struct FlatExtent {
  double left, right, bottom, top;
};

inline FlatExtent flat_extent(std::span<const Point3> vertices) {
  FlatExtent e{vertices[0].x, vertices[0].x, vertices[0].y, vertices[0].y};
  for (const Point3& v : vertices) {
    e.left = std::min(e.left, v.x);
    e.right = std::max(e.right, v.x);
    e.bottom = std::min(e.bottom, v.y);
    e.top = std::max(e.top, v.y);
  }
  return e;
}

}  // namespace displayfile
