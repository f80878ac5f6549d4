#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "clip/point.h"
#include "hidden/exact/double_double.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

// The expressions of predicates on stored points, as the sum of two doubles with a bound: their
// middle stage, between doubles and exact numbers, where is_double_double_sound
// (hidden/exact/predicates.md, sections 5 and 9).

/// A value and its error bound.
struct Estimate {
  DoubleDouble value;
  double error;
};

/// The value's sign; 0: undecided. The error bounds allow for ignoring the lower part.
inline int decided_sign(const Estimate& estimate) {
  assert(!(estimate.error < 0.0));
  return std::abs(estimate.value.high) > estimate.error ? sign_of(estimate.value.high) : 0;
}

inline constexpr double kNothingKnown = std::numeric_limits<double>::infinity();

/// d x (v - p).
inline Estimate estimated_turn(const Point2& p, const DoubleDouble& dx, const DoubleDouble& dy,
                               const Point2& v) {
  constexpr double kError = 0x1p-101;
  const DoubleDouble left = dx * exact_difference(v.y, p.y);
  const DoubleDouble right = dy * exact_difference(v.x, p.x);
  return {left - right, kError * (std::abs(left.high) + std::abs(right.high)) + kTiny};
}

/// The largest distance along an axis of a plane's points, and another, from its first point.
inline double reach_along(const Plane& plane, double at, int axis) {
  return std::max({std::abs(plane.q[axis] - plane.p[axis]), std::abs(plane.r[axis] - plane.p[axis]),
                   std::abs(at - plane.p[axis])});
}

/// One component of the plane's normal.
inline DoubleDouble normal_along(const Plane& plane, int axis) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const auto side = [&](const Point3& end, int i) { return exact_difference(end[i], plane.p[i]); };
  return side(plane.q, j) * side(plane.r, k) - side(plane.q, k) * side(plane.r, j);
}

/// The plane's value at v. Nothing is known for planes with rests, here and below.
inline Estimate estimated_value(const Plane& plane, const Point3& v) {
  constexpr double kError = 0x1p-97;
  constexpr double kUnderflow = 0x1p-700;
  if (!plane.is_plain()) return {{}, kNothingKnown};
  DoubleDouble sum;
  for (int i = 0; i < 3; ++i) {
    sum = sum + normal_along(plane, i) * exact_difference(v[i], plane.p[i]);
  }
  const double size =
      reach_along(plane, v.x, 0) * (reach_along(plane, v.y, 1) * reach_along(plane, v.z, 2));
  return {sum, kError * size + kUnderflow};
}

/// The terms for comparing depths of planes.
struct PlaneEstimate {
  explicit PlaneEstimate(const Plane& plane_)
      : plane(plane_),
        a(normal_along(plane_, 0)),
        b(normal_along(plane_, 1)),
        c(normal_along(plane_, 2)) {}
  /// A (x - p.x) + B (y - p.y).
  DoubleDouble slope(const Point2& at) const {
    return a * exact_difference(at.x, plane.p.x) + b * exact_difference(at.y, plane.p.y);
  }
  const Plane& plane;
  DoubleDouble a, b, c;
};

/// The difference of two planes' depths times both C.
inline Estimate estimated_apart(const PlaneEstimate& one, const PlaneEstimate& other,
                                const Point2& at) {
  constexpr double kError = 0x1p-97, kUnderflow = 0x1p-600, kLargestFigure = 0x1p+100;
  if (!one.plane.is_plain() || !other.plane.is_plain()) return {{}, kNothingKnown};
  const DoubleDouble apart = exact_difference(one.plane.p.z, other.plane.p.z);
  const DoubleDouble value =
      apart * one.c * other.c - one.slope(at) * other.c + other.slope(at) * one.c;
  const auto flat = [&](const Plane& p) {
    return reach_along(p, at.x, 0) * reach_along(p, at.y, 1);
  };
  const double flat_one = flat(one.plane), flat_other = flat(other.plane);
  const double high_one = reach_along(one.plane, one.plane.p.z, 2);
  const double high_other = reach_along(other.plane, other.plane.p.z, 2);
  const double high = std::abs(apart.high) + high_one + high_other;
  // Larger numbers could magnify underflow.
  if (!(std::max(std::max(flat_one, flat_other), high) < kLargestFigure))
    return {value, kNothingKnown};
  return {value, kError * (flat_one * flat_other * high) + kUnderflow};
}

}  // namespace displayfile
