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

/// What points are defined by: the scene's stored points and planes, by index. The arrays may
/// move between calls, but what an index means must stay.
struct Definitions {
  std::span<const Point3> points;
  std::span<const Plane> planes;
};

/// A point that splitting made, kept as what it is, so that pieces of pieces stay exact to any
/// depth: every vertex of a piece is a vertex of the polygon, an edge of it cut by a plane, or
/// its plane cut by two.
///
/// A polygon's depth is that of its support plane everywhere, and a vertex off that plane
/// counts as moved along z on to it: the lifted kinds say so exactly. In world coordinates, where
/// a plane may be parallel to z, it is moved along the axis that the plane faces (facing_axis).
///
/// Beside the definition stand doubles close to the point: the filter's, never the answer's.
struct DefinedPoint {
  enum class Kind : std::uint8_t {
    stored,           ///< `near` itself
    lifted,           ///< point a moved along the axis on to plane own
    edge_cut,         ///< the line through points a and b, met by plane cut
    lifted_edge_cut,  ///< the same line moved along the axis on to plane own, met by plane cut
    plane_cut,        ///< planes own, a and cut
  };
  Point3 near{0.0};     ///< of a lifted point the other coordinates are its own
  double radius = 0.0;  ///< no coordinate is farther than this from near's; may be infinite
  Kind kind = Kind::stored;
  std::uint8_t axis = 2;           ///< of the lifted kinds: 0, 1, 2 for x, y, z
  bool has_rest = false;           ///< near is the closest there is, and the rest is known
  std::uint32_t a = 0, b = 0;      ///< points; a is a plane in a plane_cut
  std::uint32_t own = 0, cut = 0;  ///< planes
  std::array<float, 3> rest{};     ///< what near lacks, in radii, where it is known
};
static_assert(sizeof(DefinedPoint) == 64, "one line of the processor's cache");

/// True if near's coordinate along that axis is the point's own: lifting changes only one.
inline bool is_known(const DefinedPoint& v, int axis) {
  return v.kind == DefinedPoint::Kind::stored ||
         (v.kind == DefinedPoint::Kind::lifted && v.axis != axis);
}
/// True if near's x and y are the point's own.
inline bool is_known_in_projection(const DefinedPoint& v) {
  return is_known(v, 0) && is_known(v, 1);
}

DefinedPoint stored_point(const Point3& p);
/// Plane own must not be parallel to the axis, here and in lifted_edge_cut.
DefinedPoint lifted_point(const Definitions& all, std::uint32_t a, std::uint32_t own, int axis = 2);
/// The line and the plane must meet in one point; where they do not, a predicate that comes to its
/// exact stage throws Error. This holds for the other cuts too.
DefinedPoint edge_cut(const Definitions& all, std::uint32_t a, std::uint32_t b, std::uint32_t cut);
DefinedPoint lifted_edge_cut(const Definitions& all, std::uint32_t a, std::uint32_t b,
                             std::uint32_t own, std::uint32_t cut, int axis = 2);
DefinedPoint plane_cut(const Definitions& all, std::uint32_t own, std::uint32_t first,
                       std::uint32_t second);

// Every predicate here returns the true sign, -1, 0 or 1, of the points as defined, for
// coordinates up to kCoordinateLimit, whatever the rounding mode. So the laws of orientation.h and
// plane.h hold of defined points too, however each is defined.

int exact_side_of_plane(const Definitions& all, const DefinedPoint& v, const Plane& plane);

/// Which side of the plane v is on (hidden/exact/plane.h).
inline int side_of_plane(const Definitions& all, const DefinedPoint& v, const Plane& plane) {
  const auto [value, bound] = plane_value(v.near, plane);
  if (std::abs(value) > bound + plane.reach * v.radius * kInflate) [[likely]] {
    return decided_sign(value);
  }
  return exact_side_of_plane(all, v, plane);
}

/// What filters see of a point: doubles close to it, and how far it is from each at most.
struct NearPoint {
  Point3 p;
  double radius;
};

/// Which way points turn in the projection of which that is known; 0: undecided.
inline int filtered_turn(const NearPoint& a, const NearPoint& b, const NearPoint& c) {
  const auto difference = [](double p, const NearPoint& of_p, double q, const NearPoint& of_q) {
    return Ball{p, of_p.radius} - Ball{q, of_q.radius};
  };
  const Ball determinant = difference(a.p.x, a, c.p.x, c) * difference(b.p.y, b, c.p.y, c) -
                           difference(a.p.y, a, c.p.y, c) * difference(b.p.x, b, c.p.x, c);
  return decided(determinant) ? decided_sign(determinant.middle) : 0;
}

/// Which way a, b, c turn in the projection (hidden/exact/orientation.h): the side of c to the line
/// from a to b.
int orientation(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b,
                const DefinedPoint& c);
/// The same if it takes no exact arithmetic; if it does, that may be because a cut has no rest.
std::optional<int> orientation_at_hand(const Definitions& all, const DefinedPoint& a,
                                       const DefinedPoint& b, const DefinedPoint& c);

/// The sign of a's coordinate less b's: compare(a, b) = -compare(b, a), and points are in one order
/// by it. So are they by compare_xy and compare_xyz below.
int compare_x(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b);
int compare_y(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b);
int compare_z(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b);

/// True if the points lie on lines of which all points have that coordinate in common, as the sides
/// of polygons that a window clipped do.
bool have_one_coordinate(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b,
                         int axis);

/// The order by x, then y: 0 if they are the same point of the projection.
int compare_xy(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b);
/// The same if it takes no exact arithmetic.
std::optional<int> compare_xy_at_hand(const Definitions& all, const DefinedPoint& a,
                                      const DefinedPoint& b);
/// The order by x, then y, then z: 0 if they are the same point.
int compare_xyz(const Definitions& all, const DefinedPoint& a, const DefinedPoint& b);

/// The point with the closest doubles there are beside its definition, so that the filters decide
/// all they can: worth its price once for a point that is badly defined, such as a cut by nearly
/// parallel planes, since it is asked about many times.
DefinedPoint refined(const Definitions& all, const DefinedPoint& v);
/// The same; nothing if the point does not exist.
std::optional<DefinedPoint> refined_if_any(const Definitions& all, const DefinedPoint& v);

/// The same, and with the first digits of what these doubles lack: for points that lie closer
/// together than doubles do. A stored point lacks nothing.
DefinedPoint with_rest(const Definitions& all, const DefinedPoint& v);

/// True if the doubles beside the definition are so far off that filters would fail.
inline bool is_badly_known(const DefinedPoint& v) {
  const double largest = std::max({std::abs(v.near.x), std::abs(v.near.y), std::abs(v.near.z)});
  return !(v.radius <= 0x1p-44 * largest);
}

/// The point's coordinates, each rounded once, to the nearest double whatever the rounding
/// mode: the same bits however the point is defined. Throws Error if the point does not exist
/// or a coordinate exceeds every double.
Point3 rounded(const Definitions& all, const DefinedPoint& v);

}  // namespace displayfile
