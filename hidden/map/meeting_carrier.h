#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <vector>

#include "hidden/exact/defined_point.h"
#include "hidden/exact/depth_order.h"
#include "hidden/exact/order_on_line.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/lines/line_table.h"
#include "hidden/lines/side_table.h"
#include "hidden/map/map_place.h"

namespace displayfile {

/// The line along which two polygons intersect, as a carrier of map edges: the counterpart of
/// SideCarrier for sides.
class MeetingCarrier {
 public:
  struct Place {
    DefinedPoint at;
    MapPlace what;
  };

  MeetingCarrier(const LineTable& scene, const SideTable& sides) : scene_(scene), sides_(sides) {}

  void look_at(const IntersectionLine& line) {
    line_ = &line;
    planes_.assign({scene_.plane(line.item_a), scene_.plane(line.item_b)});
    order_ = OrderOnLine(planes_[0], planes_[1]);
    from_ = line.from.near;
    to_ = line.to.near;
    start_ = {line.from, what(line.from)};
    end_ = {line.to, what(line.to)};
    left_is_first_ = finds_first_on_left();
  }

  const Point3& from() const { return from_; }
  const Point3& to() const { return to_; }
  const Place& start() const { return start_; }
  const Place& end() const { return end_; }

  /// True if the first polygon is nearer on the left, which is the same along the whole line.
  bool first_is_nearer_on_left() const { return left_is_first_; }

  int side(const Point3& p) const {
    const int nearer = order_above(p, planes_[0], planes_[1]);
    return left_is_first_ ? nearer : -nearer;
  }

  Place at_point(std::uint32_t p) const {
    return cut_off({lifted_point(definitions(), p, 0), MapPlace::at_point(p)});
  }
  Place crossing(std::uint32_t p, std::uint32_t q) const {
    return cut_off({lifted_edge_cut(definitions(), p, q, 0, 1),
                    MapPlace::meeting(p, q, line_->item_a, line_->item_b)});
  }
  /// One of the two polygons belongs to the line.
  Place meeting(std::uint32_t item, const Plane& plane, std::uint32_t other,
                const Plane& of_other) {
    const bool first = item != line_->item_a && item != line_->item_b;
    assert(first != (other != line_->item_a && other != line_->item_b));
    planes_.push_back(first ? plane : of_other);
    const auto third = static_cast<std::uint32_t>(planes_.size() - 1);
    return cut_off({plane_cut(definitions(), 0, 1, third),
                    MapPlace::planes(line_->item_a, line_->item_b, first ? item : other)});
  }

  int order_at_start(const Plane& one, const Plane& other) const {
    return depth_order(definitions(), one, other, line_->from);
  }
  int order_at_end(const Plane& one, const Plane& other) const {
    return depth_order(definitions(), one, other, line_->to);
  }

  int order_beside(const Plane& one, const Plane& other, const Point3& at) const {
    return order_above(at, one, other);
  }

  /// The line's ends are in this order by x, then y. compare(p, q) = -compare(q, p).
  int compare(const Place& p, const Place& q) const {
    if (p.what == q.what) return 0;
    return order_.compare(definitions(), p.at, q.at);
  }

 private:
  Definitions definitions() const {
    assert(planes_.size() >= 2);
    return {scene_.points(), planes_};
  }

  static bool has_corner(const DefinedPoint& v) {
    return v.kind == DefinedPoint::Kind::stored || v.kind == DefinedPoint::Kind::lifted;
  }
  MapPlace what(const DefinedPoint& v) const {
    const std::uint32_t a = sides_.vertex(v.a);
    return has_corner(v) ? MapPlace::at_point(a)
                         : MapPlace::meeting(a, sides_.vertex(v.b), line_->item_a, line_->item_b);
  }

  Place cut_off(const Place& place) const {
    if (compare(place, start_) <= 0) return start_;
    return compare(place, end_) >= 0 ? end_ : place;
  }

  /// Decided by a corner beside the line.
  bool finds_first_on_left() const {
    for (std::uint32_t k = 0; k < scene_.sides(line_->item_a); ++k) {
      const Point3& corner = scene_.corner(line_->item_a, k);
      const int nearer = order_above(corner, planes_[0], planes_[1]);
      if (nearer == 0) continue;
      return nearer == orientation(definitions(), line_->from, line_->to, stored_point(corner));
    }
    return true;
  }

  const LineTable& scene_;
  const SideTable& sides_;
  const IntersectionLine* line_ = nullptr;
  std::vector<Plane> planes_;  // the two, and those of places
  Point3 from_{0.0}, to_{0.0};
  Place start_, end_;
  OrderOnLine order_;
  bool left_is_first_ = true;
};

}  // namespace displayfile
