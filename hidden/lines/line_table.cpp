#include "hidden/lines/line_table.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <limits>
#include <optional>
#include <string>

#include "clip/base/error.h"
#include "clip/base/parallel.h"
#include "clip/geometry/bounds.h"
#include "clip/geometry/rectangle.h"
#include "hidden/exact/ball.h"
#include "hidden/exact/depth_order.h"
#include "hidden/exact/support_plane.h"
#include "hidden/lines/end_on_plane.h"
#include "hidden/lines/side_table.h"

namespace displayfile {

namespace {

void check_name(const Primitives& items, const LineName& name) {
  const bool exists = name.item < items.items.size();
  const auto text = [&] {
    return "no line ends at corner " + std::to_string(name.corner) + " of item " +
           std::to_string(name.item);
  };
  if (!exists) throw Error(text() + ": there are " + std::to_string(items.items.size()) + " items");
  const Primitives::Item& item = items.items[name.item];
  if (item.kind == Primitives::Kind::line && name.corner != 1) {
    throw Error(text() + ", a line: expected corner 1");
  }
  if (name.corner >= item.sides) {
    throw Error(text() + ": it has " + std::to_string(item.sides) + " corners, from 0");
  }
}

/// Primitives::touching; infinite if that is 0 although some ends are within reach: the reach is
/// then a large part of the picture.
double touching_of(const Primitives& items) {
  if (items.ends == nullptr || items.touching > 0.0) return items.touching;
  return std::numeric_limits<double>::infinity();
}

/// Bounds the double areas of three triangles in the projection, whose sides are no longer along x
/// and y than the box around all points.
double most_shares_of(const Primitives& items) {
  Rectangle all = Rectangle::nothing();
  for (const Point3& p : items.points) all.include(Point2(p));
  return 6.0 * (all.x_max - all.x_min) * (all.y_max - all.y_min);
}

}  // namespace

LineTable::LineTable(const Primitives& items, std::span<const LineName> names, int threads,
                     std::span<const IntersectionLine> intersections)
    : items_(items),
      names_(names),
      intersections_(intersections),
      support_(items.items.size()),
      extents_(items.items.size()),
      touching_(touching_of(items)) {
  require_names(items, names);
  if (touching_ > 0.0) most_shares_ = most_shares_of(items);
  in_even_parts(items.items.size(), threads, [&](std::uint32_t i) {
    support_[i] = support_of(i);
    extents_[i] = hides(i) ? extent_of(i) : Extent::nothing();
  });
  find_uneven(threads);
  add_lines();
  add_intersections();
}

void LineTable::require_names(const Primitives& items, std::span<const LineName> names) {
  for (const LineName& name : names) check_name(items, name);
}

LineTable::Support LineTable::support_of(std::uint32_t number) const {
  const Primitives::Item& item = items_.items[number];
  if (item.kind == Primitives::Kind::line) return {};
  Support support;
  if (items_.has_own_plane(number)) {
    const SupportVertices vertices = support_vertices(items_.points_of(item));
    if (vertices.edge_on) return {};
    support = {items_.point(item.first + vertices.index[0]),
               items_.point(item.first + vertices.index[1]),
               items_.point(item.first + vertices.index[2])};
  } else {
    const auto& [p, q, r] = items_.planes[number];
    support = {p, q, r};
  }
  const auto& points = items_.points;
  const int turn = orientation(points[support.p], points[support.q], points[support.r]);
  if (turn == 0) return {};
  support.is_turned = turn < 0;
  if (support.is_turned) std::swap(support.q, support.r);
  return support;
}

void LineTable::include_on_plane(Bounds& box, const Point3& at, const Plane& plane) {
  const PlaneValue slope = slope_value(plane, {at.x, at.y, 0.0});
  const Ball depth =
      Ball{plane.p.z} - Ball{slope.value, slope.bound} / Ball{plane.normal.z, plane.bound.z};
  const double more = 2.0 * depth.radius;  // the sums below are rounded
  box.include(Point3(at.x, at.y, depth.middle - more));
  box.include(Point3(at.x, at.y, depth.middle + more));
}

Extent LineTable::extent_of(std::uint32_t item) const {
  const Primitives::Item& polygon = items_.items[item];
  Bounds box;
  if (polygon.sides == 3 && items_.has_own_plane(item)) {
    for (std::uint32_t k = 0; k < 3; ++k) box.include(corner(item, k));
  } else {
    const Plane support = plane(item);
    for (std::uint32_t k = 0; k < polygon.sides; ++k) {
      include_on_plane(box, corner(item, k), support);
    }
  }
  // Lines are compared with polygons that are at most this far beside them.
  constexpr double kOfRounding = 0x1p-50;
  const double off = std::max(off_lines().in_picture, off_lines().touching);
  const double beside_it = off > 0.0 ? off + kOfRounding : 0.0;
  const Point3 beside(beside_it, beside_it, 0.0);
  return Extent::between(box.low - beside, box.high + beside);
}

Extent LineTable::extent(const Line& line) const {
  const Point3 &a = point(line.a), &b = point(line.b);
  if (const IntersectionLine* intersection = this->intersection(line)) {
    Extent box = Extent::nothing();
    box.include(a, intersection->from.radius);
    box.include(b, intersection->to.radius);
    return box;
  }
  Bounds box;
  if (!line.by_plane) {
    box.include(a);
    box.include(b);
  } else {
    const Plane own = plane(line.own);
    include_on_plane(box, a, own);
    include_on_plane(box, b, own);
  }
  return Extent::between(box.low, box.high);
}

/// A polygon of more than three sides need not be planar. Most are, except for rounding.
void LineTable::find_uneven(int threads) {
  first_corner_.reserve(items_.items.size() + 1);
  std::uint32_t corners = 0;
  bool all_flat = true;
  const auto may_be_uneven = [&](std::size_t i) {
    const Primitives::Item& item = items_.items[i];
    return item.kind != Primitives::Kind::line &&
           (item.sides > 3 || !items_.has_own_plane(i) || items_.plane_rest(i) != Point3(0.0));
  };
  for (std::size_t i = 0; i < items_.items.size(); ++i) {
    first_corner_.push_back(corners);
    corners += items_.items[i].sides;
    all_flat = all_flat && !may_be_uneven(i);
  }
  if (all_flat) return;
  off_plane_.resize(corners, OffPlane::none);
  std::atomic<bool> is_any = false;
  in_even_parts(items_.items.size(), threads, [&](std::uint32_t i) {
    const Support& support = support_[i];
    if (support.p == kNone || !may_be_uneven(i)) return;
    const Plane own = plane(i);
    for (std::uint32_t k = 0; k < sides(i); ++k) {
      const Point3& v = corner(i, k);
      if (own.goes_through(v) || side_of_plane(v, own) == 0) continue;
      const bool by_rounding = has_own_depth(v, own, touching_, items_.rounding);
      off_plane_[first_corner_[i] + k] = by_rounding ? OffPlane::by_rounding : OffPlane::as_entered;
      is_any = true;
    }
  });
  if (!is_any) off_plane_.clear();
}

bool LineTable::is_uneven(const LineName& side) const {
  if (items_.items[side.item].kind == Primitives::Kind::line) return false;
  return is_uneven_at(side.item, side.corner) || is_uneven_at(side.item, corner_before(side));
}

/// Adds a side once for each depth that the polygons sharing it give it.
void LineTable::add_lines() {
  std::optional<SideTable> shared;
  if (!off_plane_.empty() && !names_.empty()) shared.emplace(items_);
  lines_.reserve(names_.size() + intersections_.size());
  first_lines_.reserve(names_.size() + intersections_.size());
  for (std::uint32_t n = 0; n < names_.size(); ++n) {
    const LineName& name = names_[n];
    const std::uint32_t first = items_.items[name.item].first;
    const std::uint32_t a = items_.point(first + corner_before(name));
    const std::uint32_t b = items_.point(first + name.corner);
    if (Point2(point(a)) == Point2(point(b))) continue;
    first_lines_.push_back(static_cast<std::uint32_t>(lines_.size()));
    const bool is_side = items_.items[name.item].kind != Primitives::Kind::line;
    if (!shared || !is_side) {
      lines_.push_back({a, b, n, is_side ? name.item : kNone, false});
      continue;
    }
    std::uint32_t even = kNone, last = kNone;
    for (const SideTable::Side& side : shared->sides_between(a, b)) {
      if (!is_uneven(side.name)) {
        even = side.name.item;
      } else if (side.name.item != last) {
        last = side.name.item;
        lines_.push_back({a, b, n, last, true});
      }
    }
    if (even != kNone) lines_.push_back({a, b, n, even, false});
    assert(lines_.size() > first_lines_.back());
  }
}

void LineTable::add_intersections() {
  if (items_.points.size() + 2 * intersections_.size() >= kNone ||
      names_.size() + intersections_.size() >= kNone) {
    throw Error("too many intersection lines: " + std::to_string(intersections_.size()));
  }
  ends_.reserve(2 * intersections_.size());
  for (const IntersectionLine& line : intersections_) {
    const auto end = static_cast<std::uint32_t>(items_.points.size() + ends_.size());
    const auto name = static_cast<std::uint32_t>(names_.size() + ends_.size() / 2);
    ends_.push_back(line.from.near);
    ends_.push_back(line.to.near);
    first_lines_.push_back(static_cast<std::uint32_t>(lines_.size()));
    lines_.push_back({end, end + 1, name, line.item_a, false});
  }
}

}  // namespace displayfile
