#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>

#include "hidden/exact/depth_order.h"
#include "hidden/exact/line_parameter.h"
#include "hidden/exact/orientation.h"
#include "hidden/lines/line_table.h"
#include "hidden/lines/side_table.h"
#include "hidden/map/map_place.h"

namespace displayfile {

/// The line of a side in the projection, from one point of the items to another, as a carrier of
/// map edges. MeetingCarrier has the same members.
class SideCarrier {
 public:
  /// A place on the line: its fraction of the way, with an error bound, and its definition.
  struct Place {
    double share, error;
    MapPlace what;
  };

  SideCarrier(const LineTable& scene, const SideTable& /*sides*/) : scene_(scene) {}

  /// The points differ in the projection.
  void look_at(std::uint32_t a, std::uint32_t b) {
    a_ = a;
    b_ = b;
    from_ = scene_.point(a);
    to_ = scene_.point(b);
    axis_ = from_.x != to_.x ? 0 : 1;
    assert(from_[axis_] != to_[axis_]);
    rises_ = from_[axis_] < to_[axis_];
  }

  const Point3& from() const { return from_; }
  const Point3& to() const { return to_; }
  Place start() const { return {0.0, 0.0, MapPlace::at_point(a_)}; }
  Place end() const { return {1.0, 0.0, MapPlace::at_point(b_)}; }

  /// The side of the line that a point is on: 1 if left of it, -1, 0.
  int side(const Point3& p) const { return orientation(Point2(from_), Point2(to_), Point2(p)); }

  /// The place of a point on the line, clamped to its ends, as the places below.
  Place at_point(std::uint32_t p) const {
    const Point3& v = scene_.point(p);
    const bool after_start = rises_ ? v[axis_] > from_[axis_] : v[axis_] < from_[axis_];
    const bool before_end = rises_ ? v[axis_] < to_[axis_] : v[axis_] > to_[axis_];
    if (!after_start) return start();
    if (!before_end) return end();
    const double share = (v[axis_] - from_[axis_]) / (to_[axis_] - from_[axis_]);
    return {share, kShareError, MapPlace::at_point(p)};
  }
  /// The place where the side from p to q, which are on opposite sides, crosses it.
  Place crossing(std::uint32_t p, std::uint32_t q) const {
    const Point2 a(from_), b(to_), c(scene_.point(p)), d(scene_.point(q));
    const OrientationValue start_value = orientation_value(c, d, a);
    const OrientationValue end_value = orientation_value(c, d, b);
    const PlaneValue at_a = with_bound({start_value.determinant, start_value.bound});
    const PlaneValue at_b = with_bound({end_value.determinant, end_value.bound});
    const MapPlace what = MapPlace::crossing(a_, b_, p, q);
    const bool is_decided = std::abs(at_a.value) > at_a.bound && std::abs(at_b.value) > at_b.bound;
    if (is_decided && decided_sign(at_a.value) != decided_sign(at_b.value)) {
      return between(at_a, at_b, what);
    }
    const double least = std::abs(std::abs(at_a.value) - std::abs(at_b.value));
    if (is_decided && least > at_a.bound + at_b.bound) {  // it crosses the line beyond an end
      return std::abs(at_a.value) < std::abs(at_b.value) ? start() : end();
    }
    const int side_a = orientation(c, d, a), side_b = orientation(c, d, b);
    if (side_a == 0) return start();
    if (side_b == 0) return end();
    const double share = crossing_parameter(a, b, c, d);
    if (side_a == side_b) return share == 0.0 ? start() : end();
    return {share, kShareError, what};
  }
  /// The place where two polygons' planes have the same depth; one is nearer at one end, the other
  /// at the other.
  Place meeting(std::uint32_t item, const Plane& plane, std::uint32_t other,
                const Plane& of_other) const {
    const PlaneValue at_a = with_bound(depth_difference(plane, of_other, {from_.x, from_.y, 0.0}));
    const PlaneValue at_b = with_bound(depth_difference(plane, of_other, {to_.x, to_.y, 0.0}));
    const MapPlace what = MapPlace::meeting(a_, b_, item, other);
    if (std::abs(at_a.value) > at_a.bound && std::abs(at_b.value) > at_b.bound) {
      return between(at_a, at_b, what);
    }
    return {meeting_parameter(Point2(from_), Point2(to_), plane, of_other), kShareError, what};
  }

  /// The sign of the first plane's depth minus the other's at the start, and at the end.
  int order_at_start(const Plane& one, const Plane& other) const {
    return order_above(from_, one, other);
  }
  int order_at_end(const Plane& one, const Plane& other) const {
    return order_above(to_, one, other);
  }

  /// The same beside it, above another point.
  int order_beside(const Plane& one, const Plane& other, const Point3& at) const {
    return order_above(at, one, other);
  }

  /// -1 if p comes before q, 1 if after it, 0 if they are one place.
  /// compare(p, q) = -compare(q, p).
  int compare(const Place& p, const Place& q) const {
    const double apart = p.share - q.share;
    if (std::abs(apart) > p.error + q.error) return decided_sign(apart);
    if (p.what == q.what) return 0;
    return compare_xy(scene_, p.what, q.what) * (rises_ ? 1 : -1);  // by x, then y
  }

 private:
  /// Bound on the error of a quotient of differences of doubles.
  static constexpr double kShareError = 0x1p-50;

  /// The filter bounds the sign; the bound of the value includes the value's own rounding.
  static PlaneValue with_bound(const PlaneValue& v) {
    return {v.value, v.bound + 8.0 * kUnit * std::abs(v.value)};
  }

  /// The zero of a value that is linear along the line, with opposite signs at its ends.
  static Place between(const PlaneValue& at_a, const PlaneValue& at_b, const MapPlace& what) {
    const double whole = std::abs(at_a.value) + std::abs(at_b.value);
    const double share = std::abs(at_a.value) / whole;
    assert(0.0 <= share && share <= 1.0);
    // |a / (a + b)| changes by no more than this if both may be off by their bounds.
    const double least = whole - (at_a.bound + at_b.bound) * kInflate;
    const double error = least > 0.0 ? (at_a.bound + at_b.bound) / least * 2.0 + kShareError : 2.0;
    return {share, error, what};
  }

  const LineTable& scene_;
  std::uint32_t a_ = 0, b_ = 0;
  Point3 from_{0.0}, to_{0.0};
  int axis_ = 0;  // in which the ends differ
  bool rises_ = true;
};

}  // namespace displayfile
