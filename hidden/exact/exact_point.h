#pragma once

#include <optional>

#include "hidden/exact/defined_point.h"
#include "hidden/exact/exact_vector.h"

namespace displayfile {

/// A plane by exact numbers: the points x with normal . (x - through) = 0.
struct ExactPlane {
  explicit ExactPlane(const Plane& plane);
  ExactVector normal, through;
};

/// The point xyz / w, by exact numbers; w is not zero.
struct ExactPoint {
  ExactVector xyz;
  ExactNumber w;
};

ExactPoint exact_point(const Point3& p);

/// Throws Error if the point that v defines does not exist.
ExactPoint exact_point(const Definitions& all, const DefinedPoint& v);
/// Nothing if it does not exist.
std::optional<ExactPoint> exact_point_if_any(const Definitions& all, const DefinedPoint& v);

/// w times the plane's value at the point.
ExactNumber value_at(const ExactPlane& plane, const ExactPoint& v);

}  // namespace displayfile
