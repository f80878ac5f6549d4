#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "clip/point.h"
#include "hidden/exact/double_double.h"
#include "hidden/exact/exact_point.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/plane.h"

namespace displayfile {

// The parameter t of a meeting point a + t (b - a) on a line from a to b: an exact rational,
// clamped to the line's ends and rounded once, to the nearest double, ties to an even last digit.
// The same bits on every machine and in every rounding mode, for any description of the same
// meeting point, for coordinates up to kCoordinateLimit. Rounding is monotonic, so results about
// intervals between such parameters hold for the exact ones, except for intervals that vanish
// (predicates.md, section 9).
//
// The parameter depends only on the meeting point: p and q may be exchanged, and so may a plane's
// points, or two planes. Along the line from b to a it is 1 - t rounded once, which may differ from
// 1 minus the rounded t.

/// The parameter where the line through p and q crosses it in the projection. The lines must not be
/// parallel.
double slow_crossing_parameter(const Point2& a, const Point2& b, const Point2& p, const Point2& q);

/// Crossings outside the line, the usual case, are clamped by the filter.
inline double crossing_parameter(const Point2& a, const Point2& b, const Point2& p,
                                 const Point2& q) {
  const OrientationValue at_a = orientation_value(p, q, a), at_b = orientation_value(p, q, b);
  const double size_a = std::abs(at_a.determinant), size_b = std::abs(at_b.determinant);
  // The filter bounds the sign; the bound of the value includes the value's own rounding.
  const double bound_a = at_a.bound + 4.0 * kUnit * size_a;
  const double bound_b = at_b.bound + 4.0 * kUnit * size_b;
  const bool one_side = size_a > bound_a && size_b > bound_b &&
                        decided_sign(at_a.determinant) == decided_sign(at_b.determinant);
  if (one_side && std::abs(size_a - size_b) > (bound_a + bound_b) * kInflate) {
    return size_a < size_b ? 0.0 : 1.0;
  }
  return slow_crossing_parameter(a, b, p, q);
}

/// The parameter of the point p, which lies on the line in the projection; a and b differ there.
double point_parameter(const Point2& a, const Point2& b, const Point2& p);

/// The parameter where the line in space meets the plane; its ends are on opposite sides.
double meeting_parameter(const Point3& a, const Point3& b, const Plane& plane);

/// The parameter where two planes have the same depth above the line of the projection. Neither is
/// edge-on; one is nearer at one end, the other at the other.
double meeting_parameter(const Point2& a, const Point2& b, const Plane& one, const Plane& other);

// ---- Lines whose ends are not doubles -------------------------------------------------------

/// An end of a line as defined, and an approximation: each coordinate as the sum of two doubles,
/// off by at most 2^-104 of it.
struct DefinedEnd {
  DefinedEnd(const Definitions& all, const DefinedPoint& v);

  ExactPoint exact;
  std::array<DoubleDouble, 3> close;
};

/// The same three functions for a line with defined ends.
double crossing_parameter(const DefinedEnd& a, const DefinedEnd& b, const Point2& p,
                          const Point2& q);
double point_parameter(const DefinedEnd& a, const DefinedEnd& b, const Point2& p);
double meeting_parameter(const DefinedEnd& a, const DefinedEnd& b, const Plane& plane);

// The exact stages, for the tests.
double exact_crossing_parameter(const Point2& a, const Point2& b, const Point2& p, const Point2& q);
double exact_point_parameter(const Point2& a, const Point2& b, const Point2& p);
double exact_meeting_parameter(const Point3& a, const Point3& b, const Plane& plane);
double exact_meeting_parameter(const Point2& a, const Point2& b, const Plane& one,
                               const Plane& other);
double exact_crossing_parameter(const DefinedEnd& a, const DefinedEnd& b, const Point2& p,
                                const Point2& q);
double exact_point_parameter(const DefinedEnd& a, const DefinedEnd& b, const Point2& p);
double exact_meeting_parameter(const DefinedEnd& a, const DefinedEnd& b, const Plane& plane);

}  // namespace displayfile
