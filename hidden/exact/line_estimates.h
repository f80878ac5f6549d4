#pragma once

#include <cmath>
#include <optional>

#include "clip/point.h"
#include "hidden/exact/double_double.h"
#include "hidden/exact/estimates.h"
#include "hidden/exact/exact_point.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

// Linear functions along a line, at one of its ends: a zero is where something meets the line
// (line_parameter.h, line_place.h). First as the sum of two doubles with a bound, then exactly.

/// A fraction of the way along a line, and its error bound.
struct EstimatedShare {
  DoubleDouble t;
  double error;
};

/// at_a / (at_a - at_b); nothing if the difference is too inaccurate.
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

/// The double to which all values within `error` of the sum round; nothing if they round to
/// different ones.
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
