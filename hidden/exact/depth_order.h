#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "hidden/exact/defined_point.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/plane.h"

namespace displayfile {

// The order of two planes along a projector (a line parallel to z): the sign of a's z less b's
// there, so 1 where a is nearer to the viewer, 0 where they meet. Neither plane may be edge-on. The
// true sign for coordinates up to kCoordinateLimit, whatever the rounding mode.
//
// depth_order(a, b, at) = -depth_order(b, a, at); 0 if both are one plane. Independent of the order
// of the points that define a plane.

/// A position of the projection, each coordinate within `error` of the true one.
struct Position {
  double x, y, error;
};

/// A (x - p.x) + B (y - p.y), with its bound: the plane's z is p.z less this over C.
inline PlaneValue slope_value(const Plane& plane, const Position& at) {
  assert(!(at.error < 0.0));
  const double x = at.x - plane.p.x, y = at.y - plane.p.y;
  const double value = plane.normal.x * x + plane.normal.y * y;
  const double bound = plane.bound.x * (std::abs(x) + at.error) +
                       plane.bound.y * (std::abs(y) + at.error) +
                       at.error * (std::abs(plane.normal.x) + std::abs(plane.normal.y)) + plane.off;
  return {value, bound};
}

/// (za - zb) Ca Cb, without a quotient, with its bound (predicates.md, section 6), which is
/// infinite for large numbers. The heights of the planes' own points are subtracted first, so that
/// level planes are distinguished however close. Linear in the projection.
inline PlaneValue depth_difference(const Plane& a, const Plane& b, const Position& at) {
  constexpr double kLargestFactor = 0x1p+330;  // three of them are far below the largest double
  const double ca = a.normal.z, cb = b.normal.z;
  const double most_ca = std::abs(ca) + a.bound.z, most_cb = std::abs(cb) + b.bound.z;
  const PlaneValue at_a = slope_value(a, at), at_b = slope_value(b, at);
  const double apart = a.p.z - b.p.z;
  const double difference = apart * ca * cb - at_a.value * cb + at_b.value * ca;
  const double bound = most_cb * (a.bound.z * std::abs(apart) + at_a.bound) +
                       most_ca * (b.bound.z * std::abs(apart) + at_b.bound) +
                       b.bound.z * std::abs(at_a.value) + a.bound.z * std::abs(at_b.value);
  const double largest = std::max(std::max(std::max(most_ca, most_cb), std::abs(apart)),
                                  std::max(std::abs(at_a.value), std::abs(at_b.value)));
  return {difference, largest <= kLargestFactor ? bound * kInflate + kTiny
                                                : std::numeric_limits<double>::infinity()};
}

/// The filter: the sign of that difference divided by that of Ca Cb, which is the order; 0:
/// undecided.
inline int filtered_depth_order(const Plane& a, const Plane& b, const Position& at) {
  const auto [difference, bound] = depth_difference(a, b, at);
  const double ca = a.normal.z, cb = b.normal.z;
  const bool decided =
      std::abs(difference) > bound && std::abs(ca) > a.bound.z && std::abs(cb) > b.bound.z;
  return decided ? decided_sign(difference) * decided_sign(ca, cb) : 0;
}

/// The plane's depth at a pixel's centre, rounded once to the nearest double; it is not edge-on.
/// Throws Error if it exceeds every double.
double exact_depth(const Plane& plane, const PixelCentre& centre);

// The exact stages.
int exact_depth_order(const Plane& a, const Plane& b, const PixelCentre& centre);
int exact_depth_order(const Plane& a, const Plane& b, const Point2& at);
int exact_depth_order(const Definitions& all, const Plane& a, const Plane& b,
                      const DefinedPoint& at);

/// The order at a pixel's centre; the planes in device coordinates.
inline int depth_order(const Plane& a, const Plane& b, const PixelCentre& centre) {
  const int order = filtered_depth_order(a, b, {centre.x, centre.y, centre.error});
  if (order != 0) [[likely]]
    return order;
  return exact_depth_order(a, b, centre);
}

/// The order at a point of the projection.
inline int depth_order(const Plane& a, const Plane& b, const Point2& at) {
  const int order = filtered_depth_order(a, b, {at.x, at.y, 0.0});
  if (order != 0) [[likely]]
    return order;
  return exact_depth_order(a, b, at);
}

/// The order at a defined point's x and y.
inline int depth_order(const Definitions& all, const Plane& a, const Plane& b,
                       const DefinedPoint& at) {
  const int order = filtered_depth_order(a, b, {at.near.x, at.near.y, at.radius});
  if (order != 0) [[likely]]
    return order;
  return exact_depth_order(all, a, b, at);
}

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
