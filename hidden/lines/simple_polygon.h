#pragma once

#include <algorithm>
#include <cstddef>

#include "clip/geometry/corners.h"
#include "clip/point.h"
#include "hidden/exact/orientation.h"
#include "hidden/triangles/convex_turning.h"

namespace displayfile {

/// True if the segments from p to q and from r to s have a point in common, exactly. Symmetric in
/// the ends of each and in the segments.
inline bool segments_meet(const Point2& p, const Point2& q, const Point2& r, const Point2& s) {
  for (int axis = 0; axis < 2; ++axis) {
    if (std::max(p[axis], q[axis]) < std::min(r[axis], s[axis]) ||
        std::max(r[axis], s[axis]) < std::min(p[axis], q[axis])) {
      return false;
    }
  }
  const int at_r = orientation(p, q, r), at_s = orientation(p, q, s);
  if (at_r * at_s > 0) return false;
  return orientation(r, s, p) * orientation(r, s, q) <= 0;
}

/// 1 or -1 if the polygon's sides meet only at shared corners, so that each has the inside on the
/// same side all along: the left if it runs counterclockwise, 1, or the right, -1. 0 if not, also
/// if two successive corners coincide in the projection; and if it is not convex and has more than
/// kMostSides, which are not compared. `at(k)` is corner k in the projection.
template <class At>
int simple_turning(std::size_t sides, const At& at) {
  constexpr std::size_t kMostSides = 128;
  const auto turn = [&](std::size_t i, std::size_t j, std::size_t k) {
    return orientation(at(i), at(j), at(k));
  };
  const auto direction = [&](std::size_t i, std::size_t j) { return direction_by_x(at(i), at(j)); };
  const int convex = convex_turning(sides, turn, direction);
  if (convex != 0 || sides <= 3 || sides > kMostSides) return convex;
  const auto after = [&](std::size_t k) { return next_corner(k, sides); };
  std::size_t first = 0;  // first by x, then y
  for (std::size_t i = 0; i < sides; ++i) {
    const std::size_t j = after(i), k = after(j);
    if (direction(i, j) == 0) return 0;
    if (turn(i, j, k) == 0 && direction(i, j) != direction(j, k)) return 0;  // it folds back
    if (direction(i, first) > 0) first = i;
    for (std::size_t m = i + 2; m < sides; ++m) {
      if (after(m) != i && segments_meet(at(i), at(j), at(m), at(after(m)))) return 0;
    }
  }
  return turn(previous_corner(first, sides), first, after(first));
}

}  // namespace displayfile
