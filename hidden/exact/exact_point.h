#pragma once

#include <optional>

#include "hidden/exact/defined_point.h"
#include "hidden/exact/exact_vector.h"

namespace displayfile {

/// A plane: the points x with normal . (x - through) = 0.
template <class Number>
struct PlaneOf {
  explicit PlaneOf(const Plane& plane);
  VectorOf<Number> normal, through;
};
using ExactPlane = PlaneOf<ExactNumber>;

/// The point xyz / w; w is not zero.
template <class Number>
struct PointOf {
  VectorOf<Number> xyz;
  Number w;
};
using ExactPoint = PointOf<ExactNumber>;

ExactPoint exact_point(const Point3& p);

/// Throws Error if the point that v defines does not exist.
ExactPoint exact_point(const Definitions& all, const DefinedPoint& v);
/// Nothing if it does not exist.
std::optional<ExactPoint> exact_point_if_any(const Definitions& all, const DefinedPoint& v);

/// The doubles nearest to the coordinates of the point that v defines, as exact numbers would give
/// them, if double-doubles decide them; they do except about once in 10^13, and for badly
/// conditioned points.
std::optional<Point3> rounded_closely(const Definitions& all, const DefinedPoint& v);

/// w times the plane's value at the point.
template <class Number>
Number value_at(const PlaneOf<Number>& plane, const PointOf<Number>& v) {
  return dot(plane.normal, v.xyz - plane.through * v.w);
}

}  // namespace displayfile
