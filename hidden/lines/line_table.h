#pragma once

#include <cassert>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "clip/geometry/bounds.h"
#include "clip/geometry/corners.h"
#include "hidden/boxes/extents.h"
#include "hidden/exact/plane.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/lines/near_line.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"

namespace displayfile {

/// Input of the hidden-line methods: the items with their planes' vertices and extents, and the
/// lines to examine. Indices and contiguous arrays; the points are the items' own.
class LineTable {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// Names are sorted and unique. Throws Error for one that names no line. Intersection lines are
  /// examined as well; the arguments must outlive this.
  LineTable(const Primitives& items, std::span<const LineName> names, int threads,
            std::span<const IntersectionLine> intersections = {});

  /// Throws Error for a name of no line.
  static void require_names(const Primitives& items, std::span<const LineName> names);

  /// A line with one depth. A side shared by polygons appears once for each of its depths.
  struct Line {
    std::uint32_t a, b;  ///< its ends, distinct in the projection
    std::uint32_t name;  ///< index of the name; from names() on, of the intersection
    std::uint32_t own;  ///< a polygon whose plane has the line's depth, or an edge-on one, or kNone
    bool by_plane;      ///< the depth is that of the plane, which differs slightly from the ends'
  };
  /// In order of names, then intersections.
  std::span<const Line> lines() const { return lines_; }
  /// The index of each name's first line.
  std::span<const std::uint32_t> first_lines() const { return first_lines_; }
  /// The same of names alone.
  std::span<const std::uint32_t> first_lines_of_names() const {
    return first_lines().first(first_lines_.size() - intersections_.size());
  }
  std::size_t names() const { return names_.size(); }
  const LineName& name(std::uint32_t n) const { return names_[n]; }
  /// A point of the items, or an intersection's rounded end.
  const Point3& point(std::uint32_t p) const {
    assert(p < items_.points.size() + ends_.size());
    return p < items_.points.size() ? items_.points[p] : ends_[p - items_.points.size()];
  }
  std::span<const Point3> points() const { return items_.points; }  ///< the items'
  std::span<const IntersectionLine> intersections() const { return intersections_; }
  /// The line's intersection; null if it is a line of the items.
  const IntersectionLine* intersection(const Line& line) const {
    return line.name < names_.size() ? nullptr : &intersections_[line.name - names_.size()];
  }

  // ---- Polygons, by the number of the item -----------------------------------------------

  std::uint32_t items() const { return static_cast<std::uint32_t>(items_.items.size()); }
  /// True for solid polygons that cover something.
  bool hides(std::uint32_t item) const {
    return support_[item].p != kNone && items_.items[item].kind == Primitives::Kind::solid;
  }
  std::uint32_t sides(std::uint32_t item) const { return items_.items[item].sides; }
  const Point3& corner(std::uint32_t item, std::uint32_t corner) const {
    return items_.points[corner_point(item, corner)];
  }
  /// The index of the corner's point.
  std::uint32_t corner_point(std::uint32_t item, std::uint32_t corner) const {
    assert(corner < sides(item));
    return items_.point(items_.items[item].first + corner);
  }
  /// The plane of a polygon that has one, its support plane or the one assigned to it, facing the
  /// viewer.
  Plane plane(std::uint32_t item) const {
    assert(support_[item].p != kNone);
    const auto& [p, q, r, is_turned] = support_[item];
    Point3 rest = items_.plane_rest(item);
    if (is_turned) std::swap(rest.y, rest.z);
    return {items_.points[p], items_.points[q], items_.points[r], rest};
  }
  /// True if that plane has rests; false for a polygon without a plane.
  bool has_rests(std::uint32_t item) const { return items_.plane_rest(item) != Point3(0.0); }
  /// As Primitives::touching; infinite if points within reach may be anywhere.
  double touching() const { return touching_; }
  /// The distance within which a corner counts as on a line (hidden/lines/near_line.h).
  OffLines off_lines() const { return displayfile::off_lines(touching_, items_.rounding); }
  /// Bound, for all points of the scene, on the sum of weights in three of them, times the double
  /// area of their triangle in the projection (hidden/lines/end_on_plane.h).
  double most_shares() const { return most_shares_; }
  /// True if two polygons are coplanar as entered.
  bool share_plane(std::uint32_t a, std::uint32_t b) const {
    return !items_.has_own_plane(a) && !items_.has_own_plane(b) &&
           items_.planes[a] == items_.planes[b];
  }
  /// The positions, as entered, of the ends of a line of the items relative to a polygon's plane.
  EndsAsEntered::Places places(const Line& line, std::uint32_t polygon) const {
    const LineName& name = names_[line.name];
    return items_.places(name.item, name.corner, polygon);
  }
  /// True if the polygon is not planar and this vertex is off its support plane, however little.
  bool is_off_plane(std::uint32_t item, std::uint32_t corner) const {
    return off_plane(item, corner) != OffPlane::none;
  }
  /// The same, by more than the rounding of viewing, or its plane has a rest. Sides of other
  /// polygons have their own ends' depth, which is the plane's: on a steep plane rounding alone
  /// would decide otherwise.
  bool is_uneven_at(std::uint32_t item, std::uint32_t corner) const {
    return off_plane(item, corner) == OffPlane::as_entered;
  }
  /// True if no polygon has such a vertex.
  bool all_even() const { return off_plane_.empty(); }
  /// The box around the area that a hiding polygon covers, at the depths of its support plane;
  /// empty for others.
  const Extent& extent(std::uint32_t item) const { return extents_[item]; }
  std::span<const Extent> extents() const { return extents_; }
  /// The box around a line, at its depths.
  Extent extent(const Line& line) const;

 private:
  /// The vertices of the support plane, as points; p is kNone if there is none.
  struct Support {
    std::uint32_t p = kNone, q = kNone, r = kNone;
    bool is_turned = false;  ///< q and r are exchanged
  };
  enum class OffPlane : std::uint8_t { none, by_rounding, as_entered };
  OffPlane off_plane(std::uint32_t item, std::uint32_t corner) const {
    return off_plane_.empty() ? OffPlane::none : off_plane_[first_corner_[item] + corner];
  }
  Support support_of(std::uint32_t item) const;
  Extent extent_of(std::uint32_t item) const;
  /// Includes a point of the projection at its depth on the plane.
  static void include_on_plane(Bounds& box, const Point3& at, const Plane& plane);
  void find_uneven(int threads);
  void add_lines();
  void add_intersections();
  /// True if the side's ends are not at the depth of the polygon's plane there, except for
  /// rounding.
  bool is_uneven(const LineName& side) const;
  std::uint32_t corner_before(const LineName& side) const {
    return previous_corner(side.corner, sides(side.item));
  }

  const Primitives& items_;
  std::span<const LineName> names_;
  std::span<const IntersectionLine> intersections_;
  std::vector<Point3> ends_;  // two per intersection
  std::vector<Support> support_;
  std::vector<Extent> extents_;
  double touching_, most_shares_ = 0.0;
  /// How the vertex at each corner of the items is off the polygon's plane; empty: none is.
  std::vector<OffPlane> off_plane_;
  std::vector<std::uint32_t> first_corner_;  // per item, among all items' corners
  std::vector<Line> lines_;
  std::vector<std::uint32_t> first_lines_;
};

}  // namespace displayfile
