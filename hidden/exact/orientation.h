#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "clip/point.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

// Every predicate here returns the true sign, -1, 0 or 1, for coordinates up to
// kCoordinateLimit, whatever the rounding mode. hidden/exact/predicates.md derives the bounds.

// The middle and the exact stages, where the filter is undecided.
int exact_orientation(const Point2& a, const Point2& b, const Point2& c);
int exact_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// The determinant in doubles; beyond its bound it has the true sign.
struct OrientationValue {
  double determinant, bound;
};
inline OrientationValue orientation_value(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double kBound = 4.0 * kUnit * kInflate;
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  return {left - right, kBound * std::abs(left + right) + kTiny};
}

/// The filter: orientation(a, b, c), or 0 where it is undecided.
inline int filtered_orientation(const Point2& a, const Point2& b, const Point2& c) {
  const auto [determinant, bound] = orientation_value(a, b, c);
  return std::abs(determinant) > bound ? decided_sign(determinant) : 0;
}

/// The turn of a, b, c: 1 counterclockwise (c is left of the line from a to b), -1 clockwise, 0 if
/// collinear.
///
/// orientation(a, b, c) = orientation(b, c, a) = -orientation(b, a, c); 0 if two points are equal.
inline int orientation(const Point2& a, const Point2& b, const Point2& c) {
  const int filtered = filtered_orientation(a, b, c);
  if (filtered != 0) [[likely]]
    return filtered;
  return exact_orientation(a, b, c);
}

/// The turn of a, b, c in the projection along z.
inline int orientation(const Point3& a, const Point3& b, const Point3& c) {
  return orientation(Point2(a.x, a.y), Point2(b.x, b.y), Point2(c.x, c.y));
}

/// The side of the plane through a, b, c on which the point d is: 1 if a, b, c run counterclockwise
/// seen from it, -1 on the other side, 0 on the plane, also if a, b, c are collinear.
///
/// The sign flips if any two of the four are exchanged; 0 if two of them are equal.
inline int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  constexpr double kBound = 48.0 * kUnit * kInflate;
  constexpr double kUnderflow = 0x1p-730;
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const double wx = d.x - a.x, wy = d.y - a.y, wz = d.z - a.z;
  const double determinant =
      wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz) + wz * (ux * vy - uy * vx);
  const double x = std::max(std::max(std::abs(ux), std::abs(vx)), std::abs(wx));
  const double y = std::max(std::max(std::abs(uy), std::abs(vy)), std::abs(wy));
  const double z = std::max(std::max(std::abs(uz), std::abs(vz)), std::abs(wz));
  const double bound = kBound * (x * (y * z)) + kUnderflow;
  if (std::abs(determinant) > bound) [[likely]]
    return decided_sign(determinant);
  return exact_orientation(a, b, c, d);
}

}  // namespace displayfile
