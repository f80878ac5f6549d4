#pragma once

#include "hidden/exact/ball.h"
#include "hidden/exact/defined_point.h"

namespace displayfile {

/// The order of points on the intersection of two planes, by x, then y, in the projection:
/// compare_xy of such points, using the line's direction to avoid exact arithmetic.
class OrderOnLine {
 public:
  OrderOnLine() = default;
  OrderOnLine(const Plane& one, const Plane& other) {
    const auto component = [](const Plane& plane, int axis) {
      return Ball{plane.normal[axis], plane.bound[axis]};
    };
    const auto along = [&](int i, int j) {  // a component of the cross product of the normals
      return component(one, i) * component(other, j) - component(one, j) * component(other, i);
    };
    may_be_along_y_ = !decided(along(1, 2));
    may_be_along_x_ = !decided(along(2, 0));
  }

  /// -1 if v comes before w, 1 if after it, 0 if they are one; both are on the line.
  /// compare(v, w) = -compare(w, v). A line that is not along y has each x once, and one not along
  /// x each y.
  int compare(const Definitions& all, const DefinedPoint& v, const DefinedPoint& w) const {
    if (may_be_along_y_) return compare_xy(all, v, w);
    if (!may_be_along_x_ && have_one_coordinate(all, v, w, 1)) return 0;
    return compare_x(all, v, w);
  }

 private:
  bool may_be_along_x_ = true, may_be_along_y_ = true;
};

}  // namespace displayfile
