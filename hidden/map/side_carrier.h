#pragma once

#include <utility>

#include "hidden/exact/line_parameter.h"
#include "hidden/lines/line_scene.h"
#include "hidden/map/map_place.h"

namespace displayfile {

/// The line of a side in the projection, from one point of the items to another, as edges of a map
/// may lie on it. What is asked of it is asked of a MeetingCarrier too.
template <class Policy>
class SideCarrier {
 public:
  /// A place on the line: its share of the way, rounded once, and what it is.
  struct Place {
    double share;
    MapPlace what;
  };

  SideCarrier(const LineScene& scene, const Policy& policy) : scene_(scene), policy_(policy) {}

  /// The points differ in the projection.
  void look_at(std::uint32_t a, std::uint32_t b) {
    a_ = a;
    b_ = b;
    from_ = scene_.point(a);
    to_ = scene_.point(b);
    axis_ = from_.x != to_.x ? 0 : 1;
    rises_ = from_[axis_] < to_[axis_];
  }

  const Point3& from() const { return from_; }
  const Point3& to() const { return to_; }
  Place start() const { return {0.0, MapPlace::at_point(a_)}; }
  Place end() const { return {1.0, MapPlace::at_point(b_)}; }

  /// The side of the line that a point is on: 1 if left of it, -1, 0.
  int side(const Point3& p) const { return policy_.turn(Point2(from_), Point2(to_), Point2(p)); }

  /// Where a point that lies on the line is, cut off at its ends, as the places below are.
  Place at_point(std::uint32_t p) const {
    const Point3& v = scene_.point(p);
    const bool after_start = rises_ ? v[axis_] > from_[axis_] : v[axis_] < from_[axis_];
    const bool before_end = rises_ ? v[axis_] < to_[axis_] : v[axis_] > to_[axis_];
    if (!after_start) return start();
    if (!before_end) return end();
    return {point_parameter(Point2(from_), Point2(to_), Point2(v)), MapPlace::at_point(p)};
  }
  /// Where the side from p to q crosses it, which are on opposite sides of it.
  Place crossing(std::uint32_t p, std::uint32_t q) const {
    const Point2 a(from_), b(to_), c(scene_.point(p)), d(scene_.point(q));
    const double share = crossing_parameter(a, b, c, d);
    if (share == 0.0 || share == 1.0) {
      const int at_a = orientation(c, d, a), at_b = orientation(c, d, b);
      if (at_a == 0) return start();
      if (at_b == 0) return end();
      if (at_a == at_b) return share == 0.0 ? start() : end();
    }
    return {share, MapPlace::crossing(a_, b_, p, q)};
  }
  /// Where two polygons' planes have the same depth; one is nearer at one end, the other at the
  /// other.
  Place meeting(std::uint32_t item, const Plane& plane, std::uint32_t other,
                const Plane& of_other) const {
    return {meeting_parameter(Point2(from_), Point2(to_), plane, of_other),
            MapPlace::meeting(a_, b_, item, other)};
  }

  /// The sign of the first plane's depth less the other's at the start, and at the end.
  int order_at_start(const Plane& one, const Plane& other) const {
    return policy_.order(one, other, from_);
  }
  int order_at_end(const Plane& one, const Plane& other) const {
    return policy_.order(one, other, to_);
  }

  /// The same beside it, above another point.
  int order_beside(const Plane& one, const Plane& other, const Point3& at) const {
    return policy_.order(one, other, at);
  }

  /// -1 if p comes before q, 1 if after it, 0 if they are one place.
  int compare(const Place& p, const Place& q) const {
    if (p.share != q.share) return p.share < q.share ? -1 : 1;
    if constexpr (Policy::kExact) {
      if (p.what != q.what) return compare_xy(scene_, p.what, q.what) * (runs_up() ? 1 : -1);
    }
    return 0;
  }

 private:
  bool runs_up() const { return rises_; }  // by x, then y

  const LineScene& scene_;
  const Policy& policy_;
  std::uint32_t a_ = 0, b_ = 0;
  Point3 from_{0.0}, to_{0.0};
  int axis_ = 0;  // along which the ends differ
  bool rises_ = true;
};

}  // namespace displayfile
