#pragma once

#include "hidden/exact/depth_order.h"

namespace displayfile {

/// The sign of one plane's depth minus another's above a stored point: 1 if it is nearer. Neither
/// is edge-on. Neighbours in a mesh, whose planes pass through the point, are detected by that.
/// order_above(at, one, other) = -order_above(at, other, one).
inline int order_above(const Point3& at, const Plane& one, const Plane& other) {
  const int order = filtered_depth_order(one, other, {at.x, at.y, 0.0});
  if (order != 0) [[likely]]
    return order;
  if (one.goes_through(at) && other.goes_through(at)) return 0;
  return exact_depth_order(one, other, Point2(at));
}

}  // namespace displayfile
