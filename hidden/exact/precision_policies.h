#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "clip/geometry/bounds.h"
#include "hidden/exact/defined_point.h"
#include "hidden/exact/depth_order.h"

namespace displayfile {

/// The line of a piece's side: an edge of its polygon, from stored point a to b, or the plane a
/// that cut it.
struct SideLine {
  static constexpr std::uint32_t kCut = std::numeric_limits<std::uint32_t>::max();
  static SideLine edge(std::uint32_t from, std::uint32_t to) {
    assert(to != kCut);
    return {from, to};
  }
  static SideLine cut_by(std::uint32_t plane) { return {plane, kCut}; }
  bool made_by_cut() const { return b == kCut; }

  std::uint32_t a, b;
};

// A precision policy: the queries of an algorithm that splits polygons, with one meaning and two
// implementations. Exact and Roundoff have the same members, so that each algorithm is written
// once:
//
//   Vertex                                a vertex of a piece
//   vertex(point, own)                    stored point `point` of a polygon in plane `own`
//   side(v, plane)                        1 in front of the plane, -1 behind, 0 on it
//   cut(from, to, line, own, plane)       where the side between two vertices, which lies on
//                                         `line` in plane `own`, meets a plane that has them on
//                                         opposite sides
//   turn(a, b, c)                         1 if c is left of a to b in the projection, -1, 0
//                                         (side takes stored points too, turn
//                                         points of the projection)
//   none_turns(a, b, c, way)              true if none of three points c turns that way
//   tolerance()                           the distance within which a vertex counts as on a plane
//   compare_xy(a, b)                      order in the projection by x, then y; 0 if the same
//   filtered_turn(a, b, c)                turn, by near(v) alone; 0: undecided
//   turn_at_hand, compare_xy_at_hand      the same if exact arithmetic is not needed
//   refine(v)                             makes later calls need less exact arithmetic
//   depth_order(p, q, at)                 1 if plane p is nearer than q at the vertex, -1, 0
//   coordinates(v)                        doubles, for the display file
//   stored(point), near(v)                a stored point as a vertex; doubles close to a vertex,
//                                         and a bound on their error
//   in_projection(v)                      doubles whose x and y are exactly v's, or null
//   use(all)                              the definitions have grown or moved
//
// Planes and points are indices into the Definitions; plane kNoPlane is a line's own.
inline constexpr std::uint32_t kNoPlane = std::numeric_limits<std::uint32_t>::max();

/// Every sign is the true one, for vertices represented by their definitions.
class Exact {
 public:
  using Vertex = DefinedPoint;

  /// The axis along which a vertex off its polygon's plane is moved onto it: in device coordinates
  /// z, where no polygon's plane may be edge-on; in world coordinates, before viewing, the one that
  /// the plane faces most.
  enum class Lift : std::uint8_t { along_z, along_facing_axis };

  explicit Exact(const Definitions& all, Lift lift = Lift::along_z) : all_(all), lift_(lift) {}

  void use(const Definitions& all) { all_ = all; }
  Vertex vertex(std::uint32_t point, std::uint32_t own) const {
    assert(point < all_.points.size());
    return own == kNoPlane ? stored_point(all_.points[point])
                           : lifted_point(all_, point, own, axis(own));
  }
  int side(const Vertex& v, std::uint32_t plane) const {
    assert(plane < all_.planes.size());
    return side_of_plane(all_, v, all_.planes[plane]);
  }
  int side(const Point3& v, std::uint32_t plane) const {
    return side_of_plane(v, all_.planes[plane]);
  }
  static double tolerance() { return 0.0; }
  Vertex cut(const Vertex&, const Vertex&, const SideLine& line, std::uint32_t own,
             std::uint32_t plane) const {
    const Vertex v = defined_cut(line, own, plane);
    return is_badly_known(v) ? refined(all_, v) : v;
  }
  /// The same; nothing if the defining planes or lines are parallel.
  std::optional<Vertex> cut_if_any(const Vertex&, const Vertex&, const SideLine& line,
                                   std::uint32_t own, std::uint32_t plane) const {
    const Vertex v = defined_cut(line, own, plane);
    return is_badly_known(v) ? refined_if_any(all_, v) : v;
  }
  int turn(const Vertex& a, const Vertex& b, const Vertex& c) const {
    return orientation(all_, a, b, c);
  }
  static int filtered_turn(const NearPoint& a, const NearPoint& b, const NearPoint& c) {
    return displayfile::filtered_turn(a, b, c);
  }
  std::optional<int> turn_at_hand(const Vertex& a, const Vertex& b, const Vertex& c) const {
    return orientation_at_hand(all_, a, b, c);
  }
  std::optional<int> compare_xy_at_hand(const Vertex& a, const Vertex& b) const {
    return displayfile::compare_xy_at_hand(all_, a, b);
  }
  void refine(Vertex& v) const {
    if (!v.has_rest && !is_known_in_projection(v)) v = with_rest(all_, v);
  }
  int turn(const Point2& a, const Point2& b, const Point2& c) const {
    const int filtered = filtered_orientation(a, b, c);
    if (filtered != 0) [[likely]]
      return filtered;
    if (a == c || b == c) return 0;  // polygons share vertices
    return exact_orientation(a, b, c);
  }
  /// Usually one of the three does, or all are far on the other side or, since polygons share
  /// vertices, at an end: then nothing else is evaluated.
  bool none_turns(const Point2& a, const Point2& b, const std::array<Point2, 3>& c, int way) const {
    bool one_does = false, all_do_not = true;
    for (const Point2& p : c) {
      const auto [determinant, bound] = orientation_value(a, b, p);
      const double value = way * determinant;
      one_does |= value > bound;
      const bool at_an_end = ((p.x == a.x) & (p.y == a.y)) | ((p.x == b.x) & (p.y == b.y));
      all_do_not &= (value < -bound) | at_an_end;
    }
    if (one_does || all_do_not) return !one_does;
    return turn(a, b, c[0]) != way && turn(a, b, c[1]) != way && turn(a, b, c[2]) != way;
  }
  int compare_xy(const Vertex& a, const Vertex& b) const {
    return displayfile::compare_xy(all_, a, b);
  }
  int depth_order(std::uint32_t p, std::uint32_t q, const Vertex& at) const {
    assert(p < all_.planes.size() && q < all_.planes.size());
    return displayfile::depth_order(all_, all_.planes[p], all_.planes[q], at);
  }
  Point3 coordinates(const Vertex& v) const { return rounded(all_, v); }
  static Vertex stored(const Point3& p) { return stored_point(p); }
  static const Point3* in_projection(const Vertex& v) {
    return is_known_in_projection(v) ? &v.near : nullptr;
  }
  static NearPoint near(const Vertex& v) { return {v.near, v.radius}; }

 private:
  Vertex defined_cut(const SideLine& line, std::uint32_t own, std::uint32_t plane) const {
    if (line.made_by_cut()) return plane_cut(all_, own, line.a, plane);
    return own == kNoPlane ? edge_cut(all_, line.a, line.b, plane)
                           : lifted_edge_cut(all_, line.a, line.b, own, plane, axis(own));
  }
  int axis(std::uint32_t own) const {
    return lift_ == Lift::along_z ? 2 : facing_axis(all_.planes[own]);
  }

  Definitions all_;
  Lift lift_;
};

/// The textbook's: plain doubles, and SIGNOF with ROUNDOFF (algorithm 9.13). Coefficients of planes
/// and lines are scaled to |A| + |B| + |C| = 1, so that ROUNDOFF is a length, whatever the
/// polygon's size.
class Roundoff {
 public:
  using Vertex = Point3;

  /// roundoff: a length, 0 or more, in the points' coordinates.
  Roundoff(const Definitions& all, double roundoff) : all_(all), roundoff_(roundoff) {}

  /// A ROUNDOFF relative to the scene: `part` of the longest side of the points' bounding box.
  static Roundoff relative(const Definitions& all, double part);

  double roundoff() const { return roundoff_; }
  double tolerance() const { return roundoff_; }

  /// SIGNOF (algorithm 9.13).
  int signof(double x) const { return (x > roundoff_) - (x < -roundoff_); }

  void use(const Definitions& all) { all_ = all; }
  Vertex vertex(std::uint32_t point, std::uint32_t) const { return all_.points[point]; }
  int side(const Vertex& v, std::uint32_t plane) const {
    const Plane& p = all_.planes[plane];
    return signof(plane_value(v, p).value / p.reach);
  }
  /// The intersection as COMPARE-POLYS finds it (algorithm 9.10), always from the same end, so
  /// that an edge and its reverse are cut at the same point.
  Vertex cut(const Vertex& start, const Vertex& end, const SideLine&, std::uint32_t,
             std::uint32_t plane) const {
    const bool reverse = std::array{end.x, end.y, end.z} < std::array{start.x, start.y, start.z};
    const Vertex &from = reverse ? end : start, &to = reverse ? start : end;
    const Plane& p = all_.planes[plane];
    const double u = plane_value(from, p).value, v = plane_value(to, p).value;
    const double w = u / (u - v);
    return (to - from) * w + from;
  }
  std::optional<Vertex> cut_if_any(const Vertex& start, const Vertex& end, const SideLine& line,
                                   std::uint32_t own, std::uint32_t plane) const {
    return cut(start, end, line, own, plane);
  }
  int turn(const Vertex& a, const Vertex& b, const Vertex& c) const {
    return turn(Point2(a), Point2(b), Point2(c));
  }
  int turn(const Point2& a, const Point2& b, const Point2& c) const {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double size = std::abs(dx) + std::abs(dy);
    return size == 0.0 ? 0 : signof((dx * (c.y - a.y) - dy * (c.x - a.x)) / size);
  }
  int filtered_turn(const NearPoint& a, const NearPoint& b, const NearPoint& c) const {
    return turn(a.p, b.p, c.p);
  }
  std::optional<int> turn_at_hand(const Vertex& a, const Vertex& b, const Vertex& c) const {
    return turn(a, b, c);
  }
  std::optional<int> compare_xy_at_hand(const Vertex& a, const Vertex& b) const {
    return compare_xy(a, b);
  }
  static void refine(Vertex&) {}
  bool none_turns(const Point2& a, const Point2& b, const std::array<Point2, 3>& c, int way) const {
    return turn(a, b, c[0]) != way && turn(a, b, c[1]) != way && turn(a, b, c[2]) != way;
  }
  int compare_xy(const Vertex& a, const Vertex& b) const {
    const int by_x = signof(a.x - b.x);
    return by_x != 0 ? by_x : signof(a.y - b.y);
  }
  int depth_order(std::uint32_t p, std::uint32_t q, const Vertex& at) const {
    return signof(depth(all_.planes[p], at) - depth(all_.planes[q], at));
  }
  Point3 coordinates(const Vertex& v) const { return v; }
  static Vertex stored(const Point3& p) { return p; }
  static const Point3* in_projection(const Vertex& v) { return &v; }
  static NearPoint near(const Vertex& v) { return {v, 0.0}; }
  /// The plane's z above a vertex.
  static double depth(const Plane& plane, const Vertex& at) {
    return plane.p.z - (plane.normal.x * (at.x - plane.p.x) + plane.normal.y * (at.y - plane.p.y)) /
                           plane.normal.z;
  }

 private:
  Definitions all_;
  double roundoff_;
};

inline Roundoff Roundoff::relative(const Definitions& all, double part) {
  if (all.points.empty()) return {all, 0.0};
  Bounds box;
  for (const Point3& p : all.points) box.include(p);
  const Point3 size = box.high - box.low;
  return {all, part * std::max({size.x, size.y, size.z})};
}

}  // namespace displayfile
