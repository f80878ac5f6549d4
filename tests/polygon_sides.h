#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "clip/point.h"

// Where a point of the picture lies in the projection of a polygon. In doubles: the answers hold
// for points that are not near a side.

namespace displayfile::test {

inline double distance_to_side(const Point2& p, const Point3& a, const Point3& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double t =
      length == 0.0 ? 0.0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0);
  return std::hypot(a.x + t * dx - p.x, a.y + t * dy - p.y);
}

inline bool is_near_a_side(std::span<const Point3> loop, const Point2& p, double near) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (distance_to_side(p, loop[i], loop[(i + 1) % loop.size()]) < near) return true;
  }
  return false;
}

/// By the even-odd rule.
inline bool covers(std::span<const Point3> loop, const Point2& p) {
  bool inside = false;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Point3 &a = loop[k], &b = loop[(k + 1) % loop.size()];
    if ((a.y < p.y) == (b.y < p.y)) continue;
    if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) < p.x) inside = !inside;
  }
  return inside;
}

}  // namespace displayfile::test
