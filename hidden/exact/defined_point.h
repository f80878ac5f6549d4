#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "hidden/exact/ball.h"
#include "hidden/exact/plane.h"

namespace displayfile {

/// The stored points and planes of a scene by which points are defined. The arrays may move between
/// calls, but the meaning of indices must not change.
struct Definitions {
  std::span<const Point3> points;
  std::span<const Plane> planes;
};

/// A point made by splitting, represented by its definition, so that pieces of pieces are exact to
/// any depth: every vertex of a piece is a vertex of the polygon, an edge of it cut by a plane, or
/// its plane cut by two.
///
/// A polygon's depth is that of its support plane everywhere; a vertex off that plane counts as
/// moved along z onto it, which the lifted kinds represent exactly. In world coordinates, where a
/// plane may be parallel to z, it is moved along the axis that the plane faces (facing_axis).
///
/// The definition has approximating doubles for filters, which never decide alone.
struct DefinedPoint {
  enum class Kind : std::uint8_t {
    stored,           ///< `near` itself
    lifted,           ///< point a moved along the axis onto plane own
    edge_cut,         ///< the line through points a and b, cut by plane cut
    lifted_edge_cut,  ///< the same line moved along the axis onto plane own, cut by plane cut
    plane_cut,        ///< planes own, a and cut
  };
  Point3 near{0.0};     ///< for a lifted point the other coordinates are exact
  double radius = 0.0;  ///< bound on the error of near's coordinates; may be infinite
  Kind kind = Kind::stored;
  std::uint8_t axis = 2;           ///< of the lifted kinds: 0, 1, 2 for x, y, z
  bool has_rest = false;           ///< near is correctly rounded, and the rest is known
  std::uint32_t a = 0, b = 0;      ///< points; a is a plane in a plane_cut
  std::uint32_t own = 0, cut = 0;  ///< planes
  std::array<float, 3> rest{};     ///< near's error in radii, if known
};
static_assert(sizeof(DefinedPoint) == 64, "one line of the processor's cache");

/// True if near's coordinate along that axis is exact: lifting changes only one.
inline bool is_known(const DefinedPoint& v, int axis) {
  return v.kind == DefinedPoint::Kind::stored ||
         (v.kind == DefinedPoint::Kind::lifted && v.axis != axis);
}
/// True if near's x and y are exact.
inline bool is_known_in_projection(const DefinedPoint& v) {
  return is_known(v, 0) && is_known(v, 1);
}

DefinedPoint stored_point(const Point3& p);
/// Plane own must not be parallel to the axis, here and in lifted_edge_cut.
DefinedPoint lifted_point(const Definitions& all, std::uint32_t a, std::uint32_t own, int axis = 2);
/// The line and the plane must meet in one point; otherwise a predicate that reaches its exact
/// stage throws Error. This also holds for the other cuts.
DefinedPoint edge_cut(const Definitions& all, std::uint32_t a, std::uint32_t b, std::uint32_t cut);
DefinedPoint lifted_edge_cut(const Definitions& all, std::uint32_t a, std::uint32_t b,
                             std::uint32_t own, std::uint32_t cut, int axis = 2);
DefinedPoint plane_cut(const Definitions& all, std::uint32_t own, std::uint32_t first,
                       std::uint32_t second);

// Every predicate here returns the true sign, -1, 0 or 1, of the points as defined, for
// coordinates up to kCoordinateLimit, whatever the rounding mode. So the laws of orientation.h and
// plane.h hold of defined points too, however each is defined.

int exact_side_of_plane(const Definitions& all, const DefinedPoint& v, const Plane& plane);

/// The side of the plane on which v is (hidden/exact/plane.h).
inline int side_of_plane(const Definitions& all, const DefinedPoint& v, const Plane& plane) {
  const auto [value, bound] = plane_value(v.near, plane);
  if (std::abs(value) > bound + plane.reach * v.radius * kInflate) [[likely]] {
    return decided_sign(value);
  }
  return exact_side_of_plane(all, v, plane);
}

/// A point as seen by filters: doubles close to it, and their error bounds.
struct NearPoint {
  Point3 p;
  double radius;
};

/// The orientation of points in the projection by these; 0: undecided.
inline int filtered_turn(const NearPoint& a, const NearPoint& b, const NearPoint& c) {
  const auto difference = [](double p, const NearPoint& of_p, double q, const NearPoint& of_q) {
    return Ball{p, of_p.radius} - Ball{q, of_q.radius};
  };
  const Ball determinant = difference(a.p.x, a, c.p.x, c) * difference(b.p.y, b, c.p.y, c) -
                           difference(a.p.y, a, c.p.y, c) * difference(b.p.x, b, c.p.x, c);
  return decided(determinant) ? decided_sign(determinant.middle) : 0;
}

/// The turn of a, b, c in the projection (hidden/exact/orientation.h): the side of c relative to
/// the line from a to b.
int orientation(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b,
                const DefinedPoint& c);
/// The same without exact arithmetic; nothing if that is needed, possibly because a cut has no
/// rest.
std::optional<int> orientation_at_hand(const Definitions& all, const DefinedPoint& a,
                                       const DefinedPoint& b, const DefinedPoint& c);

/// The sign of a's coordinate less b's: compare(a, b) = -compare(b, a), and points are in one order
/// by it. So are they by compare_xy below.
int compare_x(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b);
int compare_y(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b);

/// True if the points lie on lines with that coordinate constant, as the sides of polygons clipped
/// by a window do.
bool have_one_coordinate(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b,
                         int axis);

/// The order by x, then y: 0 if they are the same point of the projection.
int compare_xy(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b);
/// The same without exact arithmetic; nothing if that is needed.
std::optional<int> compare_xy_at_hand(const Definitions& all, const DefinedPoint& a,
                                      const DefinedPoint& b);

/// The point with correctly rounded doubles, so that filters decide as often as possible: worth its
/// cost once for a badly conditioned point, such as a cut by nearly parallel planes, which is used
/// many times.
DefinedPoint refined(const Definitions& all, const DefinedPoint& v);
/// The same; nothing if the point does not exist.
std::optional<DefinedPoint> refined_if_any(const Definitions& all, const DefinedPoint& v);

/// The same, with the first digits of these doubles' errors: for points closer together than
/// doubles. A stored point has no error.
DefinedPoint with_rest(const Definitions& all, const DefinedPoint& v);

/// True if the doubles are so inaccurate that filters would fail.
inline bool is_badly_known(const DefinedPoint& v) {
  const double largest = std::max({std::abs(v.near.x), std::abs(v.near.y), std::abs(v.near.z)});
  return !(v.radius <= 0x1p-44 * largest);
}

/// The point's coordinates, each rounded once, to the nearest double whatever the rounding
/// mode: the same bits however the point is defined. Throws Error if the point does not exist
/// or a coordinate exceeds every double.
Point3 rounded(const Definitions& all, const DefinedPoint& v);

}  // namespace displayfile
