#pragma once

#include <span>

#include "clip/point.h"

namespace displayfile {

/// The rectangle around one point or more in the projection, for the minimax test; exact.
/// (hidden/boxes/extents.h has boxes in space, rounded outward.)
inline Rectangle bounding_rectangle(std::span<const Point3> vertices) {
  Rectangle r = Rectangle::nothing();
  for (const Point3& v : vertices) r.include(Point2(v));
  return r;
}

}  // namespace displayfile
