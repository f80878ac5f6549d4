#pragma once

#include <cstddef>

#include "clip/geometry/corners.h"
#include "clip/point.h"

namespace displayfile {

/// 1 or -1 if a polygon of n vertices turns one way all around, once, counterclockwise or
/// clockwise; 0 if not, also if two successive vertices coincide or all are collinear. A polygon
/// that turns one way goes around once if it changes direction twice, for any choice of forward
/// direction.
///
/// turn(i, j, k) is the sign of the turn from vertex i over j to k; direction(i, j) is 1 if j comes
/// after i by x, or by y where x is equal, -1 if before and 0 if they are one point. The caller
/// determines their exactness. With exact ones the result does not depend on the first vertex, and
/// flips if the order is reversed.
template <class Turn, class Direction>
int convex_turning(std::size_t n, const Turn& turn, const Direction& direction) {
  if (n < 3) return 0;
  if (n == 3) return turn(0, 1, 2);
  int turning = 0, reversals = 0;
  int last_direction = direction(n - 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = next_corner(i, n), k = next_corner(j, n);
    const int way = direction(i, j);
    if (way == 0) return 0;
    if (way != last_direction) ++reversals;
    last_direction = way;
    const int side = turn(i, j, k);
    if (side == 0) continue;
    if (turning == -side) return 0;
    turning = side;
  }
  return reversals == 2 ? turning : 0;
}

/// The direction between points as they are. direction_by_x(p, q) = -direction_by_x(q, p).
inline int direction_by_x(const Point2& from, const Point2& to) {
  if (from.x != to.x) return to.x > from.x ? 1 : -1;
  return (to.y > from.y) - (to.y < from.y);
}

}  // namespace displayfile
