#pragma once

#include <cmath>

#include "clip/point.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

/// A plane given by three points, exactly; and its normal in doubles with the bounds that the
/// filters need. Any coordinate system; z toward the viewer for depths. The positive side is the
/// one from which p, q, r run counterclockwise: for a light face visible to the viewer, the
/// viewer's. Collinear points give no plane: every point is then on it.
///
/// Where doubles are too coarse for a plane's depth, each point's z has a rest: z and rest together
/// are its exact depth. Few planes have rests; no rest is larger than the rounding that it
/// represents.
struct Plane {
  Plane() = default;
  Plane(const Point3& p_, const Point3& q_, const Point3& r_, const Point3& rest_ = Point3(0.0));

  bool same_points(const Plane& other) const {
    return p == other.p && q == other.q && r == other.r && rest == other.rest;
  }
  bool goes_through(const Point3& v) const {
    return (v == p || v == q || v == r) && (is_plain() || goes_through_point(v));
  }
  /// True if no point has a rest.
  bool is_plain() const { return rest == Point3(0.0); }

  Point3 p{0.0}, q{0.0}, r{0.0};
  Point3 rest{0.0};    ///< of the depths of p, q and r
  double off = kTiny;  ///< error of a value from omitting p's rest, at least kTiny
  Point3 normal{0.0};  ///< (A, B, C), close to (q - p) x (r - p)
  Point3 bound{0.0};   ///< of each component's error, with what the filter's products add
  double reach = 0.0;  ///< |A| + |B| + |C| and their bounds: how fast the value can change

 private:
  bool goes_through_point(const Point3& v) const {
    return (v == p && rest.x == 0.0) || (v == q && rest.y == 0.0) || (v == r && rest.z == 0.0);
  }
};

int exact_side_of_plane(const Point3& v, const Plane& plane);

/// The value of the plane at v, with its bound: what the filter of side_of_plane computes
/// (predicates.md, section 4). The value is |normal| times the distance, positive in front.
struct PlaneValue {
  double value, bound;
};
inline PlaneValue plane_value(const Point3& v, const Plane& plane) {
  const double x = v.x - plane.p.x, y = v.y - plane.p.y, z = v.z - plane.p.z;
  const double value = plane.normal.x * x + plane.normal.y * y + plane.normal.z * z;
  const double bound = plane.bound.x * std::abs(x) + plane.bound.y * std::abs(y) +
                       plane.bound.z * std::abs(z) + plane.off;
  return {value, bound};
}

/// The side of the plane on which v is: 1, -1, or 0 on it. True for coordinates up to
/// kCoordinateLimit, whatever the rounding mode.
///
/// The sign flips if two of the plane's points are exchanged with their rests. For a plane without
/// rests it is orientation(p, q, r, v), and 0 at p, q and r.
inline int side_of_plane(const Point3& v, const Plane& plane) {
  const auto [value, bound] = plane_value(v, plane);
  if (std::abs(value) > bound) [[likely]]
    return decided_sign(value);
  return exact_side_of_plane(v, plane);
}

/// The axis closest to the plane's normal in doubles, 0, 1 or 2 for x, y or z; never one parallel
/// to the plane. The plane's points must not be collinear.
int facing_axis(const Plane& plane);

/// The sign of C: 1 if the plane turns its positive side to the viewer, 0 if it is edge-on. It is
/// orientation(p, q, r), and flips where two of the points change places.
inline int facing(const Plane& plane) {
  if (std::abs(plane.normal.z) > plane.bound.z) [[likely]]
    return decided_sign(plane.normal.z);
  return orientation(plane.p, plane.q, plane.r);
}

}  // namespace displayfile
