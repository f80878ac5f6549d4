#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "hidden/exact/precision_policies.h"

namespace displayfile {

/// The vertices of polygons and their pieces by number, and the planes: first the points as
/// entered, then those made by the precision policy. Polygons that share a number share a vertex.
///
/// A vertex made by a cut is refined when it first needs exact arithmetic for its orientation or
/// that of another, since it will be used again. So only one thread at a time may call these for
/// such vertices; other const members, and these for other vertices, may be called by several.
template <class Policy>
class VertexTable {
 public:
  using Vertex = typename Policy::Vertex;

  /// The points must outlive this.
  VertexTable(std::span<const Point3> points, std::vector<Plane> planes, const Policy& policy)
      : points_(points), planes_(std::move(planes)), policy_(policy) {
    policy_.use({points_, planes_});
  }

  /// The vertex number of a point of a polygon in that plane.
  std::uint32_t enter(std::uint32_t point, std::uint32_t own) {
    assert(point < points_.size() && (own == kNoPlane || own < planes_.size()));
    if (own == kNoPlane || planes_[own].goes_through(points_[point])) return point;
    return keep(policy_.vertex(point, own));
  }
  /// The vertex where a side crosses a plane that separates its ends. An end that counts as on the
  /// side's planes may be off them: then the common point of these planes may be elsewhere or not
  /// exist, and the end nearer to the plane is used.
  std::uint32_t cut(std::uint32_t from, std::uint32_t to, const SideLine& line, std::uint32_t own,
                    std::uint32_t plane) {
    if (!(touching_ > 0.0)) [[likely]]
      return keep(policy_.cut(at(from), at(to), line, own, plane));
    const auto v = policy_.cut_if_any(at(from), at(to), line, own, plane);
    if (v && is_between(policy_.near(*v), near(from), near(to))) return keep(*v);
    const auto off = [&](std::uint32_t end) {
      return std::abs(plane_value(near(end).p, planes_[plane]).value);
    };
    return off(from) <= off(to) ? from : to;
  }
  std::uint32_t add_plane(const Plane& plane) {
    planes_.push_back(plane);
    policy_.use({points_, planes_});
    return static_cast<std::uint32_t>(planes_.size() - 1);
  }

  /// Replaces a plane by which no vertex is defined.
  void set_plane(std::uint32_t i, const Plane& plane) {
    assert(i < planes_.size());
    planes_[i] = plane;
  }

  /// Identifies two planes: items in either are in both.
  void share_plane(std::uint32_t plane, std::uint32_t with) {
    assert(plane < planes_.size() && with < planes_.size());
    while (counts_as_.size() < planes_.size()) {
      counts_as_.push_back(static_cast<std::uint32_t>(counts_as_.size()));
    }
    counts_as_[plane] = with;
  }
  bool in_one_plane(std::uint32_t p, std::uint32_t q) const {
    if (p == q) return true;
    return p < counts_as_.size() && q < counts_as_.size() && counts_as_[p] == counts_as_[q];
  }

  double tolerance() const { return policy_.tolerance(); }
  /// Sets the distance, per coordinate, by which viewing may separate points entered in one place
  /// (Primitives::touching).
  void set_touching(double touching) { touching_ = touching; }
  double touching() const { return touching_; }
  /// A plane's value at a vertex.
  struct Value {
    double size;   ///< in doubles
    int sign;      ///< side of the vertex
    bool is_near;  ///< within about the touching distance: then the sign is 0
  };
  Value value(std::uint32_t v, std::uint32_t plane_number) const {
    const Plane& plane = planes_[plane_number];
    const NearPoint at = near(v);
    const auto [value, bound] = plane_value(at.p, plane);
    const double size = std::abs(value);
    const double off = bound + plane.reach * at.radius * kInflate;
    const double close = plane.reach * touching_;
    if (size > off + close) [[likely]]
      return {size, decided_sign(value), false};
    // Doubles with an error above the touching distance do not prove that it is close.
    if (!(off <= close)) return {size, side(v, plane_number), false};
    return {size, 0, true};
  }
  int side(std::uint32_t v, std::uint32_t plane) const {
    if (v < points_.size()) [[likely]]
      return policy_.side(points_[v], plane);
    return policy_.side(made_[v - points_.size()], plane);
  }
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (a == b || b == c || a == c) return 0;
    const Point3 *p = in_projection(a), *q = in_projection(b), *r = in_projection(c);
    if (p != nullptr && q != nullptr && r != nullptr) [[likely]]
      return policy_.turn(Point2(*p), Point2(*q), Point2(*r));
    const int filtered = policy_.filtered_turn(near(a), near(b), near(c));
    return filtered != 0 ? filtered : turn_closely(a, b, c);
  }
  /// The orientation of points as entered, in the projection.
  int turn(const Point2& a, const Point2& b, const Point2& c) const {
    return policy_.turn(a, b, c);
  }
  /// The same as turn, but 0 also within about the touching distance of the line.
  int turn_beyond(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (!(touching_ > 0.0)) [[likely]]
      return turn(a, b, c);
    if (a == b || b == c || a == c) return 0;
    const NearPoint p = near(a), q = near(b), r = near(c);
    const auto [determinant, bound] = orientation_value(p.p, q.p, r.p);
    const double close = touching_ * taxicab(q.p, p.p);
    const double off =
        bound + (p.radius + q.radius + r.radius) * (taxicab(p.p, r.p) + taxicab(q.p, r.p));
    if (!(off <= close)) return turn(a, b, c);
    return std::abs(determinant) > 2.0 * close ? decided_sign(determinant) : 0;
  }
  /// True if none of the three turns that way from a to b, beyond the touching distance.
  bool none_turns(const Point2& a, const Point2& b, const std::array<Point2, 3>& c, int way) const {
    if (touching_ > 0.0) {
      const double close = touching_ * taxicab(a, b);
      bool one_does = false, one_is_close = false;
      for (const Point2& p : c) {
        const auto [determinant, bound] = orientation_value(a, b, p);
        const double value = way * determinant;
        one_does |= value > 2.0 * close + bound;
        one_is_close |= !(bound <= close);
      }
      if (one_does || !one_is_close) return !one_does;
    }
    return policy_.none_turns(a, b, c, way);
  }
  /// A point with exactly the vertex' x and y, if known; valid until the next vertex is made.
  const Point3* in_projection(std::uint32_t v) const {
    if (v < points_.size()) [[likely]]
      return &points_[v];
    return Policy::in_projection(made_[v - points_.size()]);
  }
  bool is_entered(std::uint32_t v) const { return v < points_.size(); }
  std::size_t made() const { return made_.size(); }
  std::size_t number_made(std::uint32_t v) const {
    assert(points_.size() <= v && v < points_.size() + made_.size());
    return v - points_.size();
  }
  const Point3& entered(std::uint32_t v) const { return points_[v]; }
  /// The direction from a to b in the projection: 1 to the right or straight up, -1 the other way;
  /// 0 if they are the same point there. direction(a, b) = -direction(b, a).
  int direction(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return 0;
    if (const auto at_hand = policy_.compare_xy_at_hand(at(b), at(a))) return *at_hand;
    for (const std::uint32_t v : {a, b}) refine(v);
    return policy_.compare_xy(at(b), at(a));
  }

  /// Doubles close to the vertex, with `radius` as the error bound per coordinate.
  NearPoint near(std::uint32_t v) const {
    assert(v < points_.size() + made_.size());
    if (v < points_.size()) return {points_[v], 0.0};
    return policy_.near(made_[v - points_.size()]);
  }
  /// The vertex's coordinates for the display file.
  Point3 coordinates(std::uint32_t v) const {
    return v < points_.size() ? points_[v] : policy_.coordinates(made_[v - points_.size()]);
  }

  const Plane& plane(std::uint32_t i) const {
    assert(i < planes_.size());
    return planes_[i];
  }
  std::size_t bytes() const {
    return made_.capacity() * sizeof(Vertex) + planes_.capacity() * sizeof(Plane);
  }

 private:
  /// Decides by the coordinates in the projection, with the touching distance.
  bool is_between(const NearPoint& v, const NearPoint& a, const NearPoint& b) const {
    const double off = v.radius + a.radius + b.radius + 16.0 * touching_;
    const auto is_between_along = [&](int axis) {
      const auto [low, high] = std::minmax(a.p[axis], b.p[axis]);
      return v.p[axis] >= low - off && v.p[axis] <= high + off;
    };
    return is_between_along(0) && is_between_along(1);
  }
  template <class Point>
  static double taxicab(const Point& a, const Point& b) {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y);
  }
  std::uint32_t keep(const Vertex& v) {
    made_.push_back(v);
    return static_cast<std::uint32_t>(points_.size() + made_.size() - 1);
  }
  Vertex at(std::uint32_t v) const {
    return v < points_.size() ? policy_.stored(points_[v]) : made_[v - points_.size()];
  }

  [[gnu::noinline]] int turn_closely(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (const auto at_hand = policy_.turn_at_hand(at(a), at(b), at(c))) return *at_hand;
    for (const std::uint32_t v : {a, b, c}) refine(v);
    return policy_.turn(at(a), at(b), at(c));
  }
  void refine(std::uint32_t v) const {
    if (v >= points_.size()) policy_.refine(made_[v - points_.size()]);
  }

  std::span<const Point3> points_;
  mutable std::vector<Vertex> made_;
  std::vector<Plane> planes_;
  std::vector<std::uint32_t> counts_as_;  // of planes; empty: none is shared
  double touching_ = 0.0;
  Policy policy_;
};

}  // namespace displayfile
