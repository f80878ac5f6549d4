#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "clip/point.h"
#include "hidden/exact/double_double.h"
#include "hidden/exact/exact_point.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

// What is linear along a line, at one of its ends: where its quotient with the other end's value is
// zero, something meets the line (line_parameter.h, line_place.h). First as the sum of two doubles
// with a bound, and then exactly.

/// A value and by how much it may be off, before the quotient.
struct Estimate {
  DoubleDouble value;
  double error;
};

inline constexpr double kNothingKnown = std::numeric_limits<double>::infinity();

/// d x (v - p).
inline Estimate estimated_turn(const Point2& p, const DoubleDouble& dx, const DoubleDouble& dy,
                               const Point2& v) {
  constexpr double kError = 0x1p-101;
  const DoubleDouble left = dx * exact_difference(v.y, p.y);
  const DoubleDouble right = dy * exact_difference(v.x, p.x);
  return {left - right, kError * (std::abs(left.high) + std::abs(right.high)) + kTiny};
}

/// How far a plane's points, and another, lie from its first along an axis.
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

/// The plane's value at v. Of a plane with rests nothing is known, here and below.
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

/// What the depths of planes are compared by.
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
  // Larger figures could make much of what is lost to underflow.
  if (!(std::max(std::max(flat_one, flat_other), high) < kLargestFigure))
    return {value, kNothingKnown};
  return {value, kError * (flat_one * flat_other * high) + kUnderflow};
}

/// A share of the way along a line, and by how much it may be off.
struct EstimatedShare {
  DoubleDouble t;
  double error;
};

/// at_a / (at_a - at_b); nothing if the difference is not known well enough.
inline std::optional<EstimatedShare> estimated_share(const Estimate& at_a, const Estimate& at_b) {
  constexpr double kDifference = 0x1p-103, kQuotient = 0x1p-100;
  const DoubleDouble whole = at_a.value - at_b.value;
  const double error_of_whole =
      at_a.error + at_b.error +
      kDifference * (std::abs(at_a.value.high) + std::abs(at_b.value.high));
  const double least = std::abs(whole.high) - error_of_whole * kInflate;
  if (!(least > 0.5 * std::abs(whole.high))) return std::nullopt;
  const DoubleDouble t = at_a.value / whole;
  const double size = std::abs(t.high);
  return EstimatedShare{
      t,
      ((at_a.error + size * error_of_whole + kTiny) / least + size * kQuotient) * (1.0 + 0x1p-20) +
          kTiny};
}

/// The double that all values so close to a sum of two round to; nothing if they do not round to
/// one.
inline std::optional<double> rounded_sum(const DoubleDouble& sum, double error) {
  const double low = sum.high + (sum.low - error), high = sum.high + (sum.low + error);
  if (low != high) return std::nullopt;  // false for NaN, where something overflowed
  return low;
}

// ---- Exactly --------------------------------------------------------------------------------

inline ExactNumber exactly_apart(double a, double b) { return ExactNumber(a) - ExactNumber(b); }

inline ExactNumber exact_turn(const Point2& a, const Point2& b, const Point2& c) {
  return exactly_apart(b.x, a.x) * exactly_apart(c.y, a.y) -
         exactly_apart(b.y, a.y) * exactly_apart(c.x, a.x);
}

/// C times the plane's depth at a point of the projection.
inline ExactNumber exact_depth(const ExactPlane& plane, const Point2& at) {
  return plane.normal.z * plane.through.z - plane.normal.x * (ExactNumber(at.x) - plane.through.x) -
         plane.normal.y * (ExactNumber(at.y) - plane.through.y);
}

/// The difference of two planes' depths, times both C, at points of the projection.
struct ExactDepths {
  ExactDepths(const Plane& one, const Plane& other) : first(one), second(other) {}
  ExactNumber apart(const Point2& at) const {
    return exact_depth(first, at) * second.normal.z - exact_depth(second, at) * first.normal.z;
  }
  ExactPlane first, second;
};

}  // namespace displayfile
