#include "hidden/lines/convex_objects.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <tuple>

#include "clip/geometry/corners.h"
#include "hidden/disjoint_sets.h"
#include "hidden/exact/orientation.h"
#include "hidden/lines/side_table.h"
#include "hidden/triangles/convex_turning.h"

namespace displayfile {

namespace {

/// Sets of polygons that share sides and lie on different sides of them in the projection, and the
/// outer sides of each set.
class Surfaces {
 public:
  Surfaces(const Primitives& items, const LineTable& scene)
      : items_(items),
        scene_(scene),
        table_(items),
        turning_(scene.items(), 0),
        sets_(scene.items()) {
    for (std::uint32_t i = 0; i < scene.items(); ++i) {
      if (scene.hides(i)) turning_[i] = static_cast<std::int8_t>(turning_of(i));
    }
    std::vector<LineName> outer;
    table_.for_each_set([&](std::span<const SideTable::Side> same) { take_side(same, outer); });
    outer_.reserve(outer.size());
    for (const LineName& side : outer) {
      outer_.push_back({sets_.name(side.item), start_of(side), end_of(side)});
    }
    std::ranges::sort(outer_, [](const OuterSide& a, const OuterSide& b) {
      return std::tie(a.set, a.from, a.to) < std::tie(b.set, b.from, b.to);
    });
  }

  /// A set's name is its lowest polygon.
  std::uint32_t set_of(std::uint32_t polygon) { return sets_.name(polygon); }

  /// Finds the outline of the set: its points counterclockwise. False if its outer sides are not
  /// one loop that turns one way, once around.
  bool find_outline(std::uint32_t set, std::vector<std::uint32_t>& outline) const {
    outline.clear();
    const auto sides = between(outer_, set, &OuterSide::set);
    if (sides.empty()) return false;
    const std::uint32_t start = sides.front().from;
    std::uint32_t at = start;
    do {
      const auto on = between(sides, at, &OuterSide::from);
      if (on.size() != 1 || outline.size() == sides.size()) return false;
      outline.push_back(at);
      at = on.front().to;
    } while (at != start);
    const auto flat = [&](std::size_t k) { return Point2(items_.points[outline[k]]); };
    return outline.size() == sides.size() && turning(outline.size(), flat) > 0;
  }

 private:
  /// A side of one polygon of a set, counterclockwise around it.
  struct OuterSide {
    std::uint32_t set, from, to;
  };
  /// The outer sides, in order, with that value of a member.
  static std::span<const OuterSide> between(std::span<const OuterSide> sides, std::uint32_t value,
                                            std::uint32_t OuterSide::*member) {
    const auto begin = std::ranges::lower_bound(sides, value, {}, member);
    const auto end = std::ranges::upper_bound(sides, value, {}, member);
    return {begin, end};
  }

  /// 1 or -1 if a polygon turns one way in the projection, once around; otherwise 0.
  template <class PointAt>
  static int turning(std::size_t n, const PointAt& at) {
    return convex_turning(
        n,
        [&](std::size_t i, std::size_t j, std::size_t k) {
          return orientation(at(i), at(j), at(k));
        },
        [&](std::size_t i, std::size_t j) { return direction_by_x(at(i), at(j)); });
  }
  int turning_of(std::uint32_t polygon) const {
    return turning(scene_.sides(polygon), [&](std::size_t k) {
      return Point2(scene_.corner(polygon, static_cast<std::uint32_t>(k)));
    });
  }

  /// The start and the end of a side in its polygon's counterclockwise direction.
  std::uint32_t start_of(const LineName& side) const { return corner_of(side, true); }
  std::uint32_t end_of(const LineName& side) const { return corner_of(side, false); }
  std::uint32_t corner_of(const LineName& side, bool start) const {
    const Primitives::Item& item = items_.items[side.item];
    const std::uint32_t before = previous_corner(side.corner, item.sides);
    const bool takes_before = start == (turning_[side.item] > 0);
    return table_.vertex(items_.point(item.first + (takes_before ? before : side.corner)));
  }

  /// Joins two polygons that run along a side in opposite directions into one set; any other side
  /// is an outer side of its polygons' sets.
  void take_side(std::span<const SideTable::Side> same, std::vector<LineName>& outer) {
    const std::size_t before = outer.size();
    for (const SideTable::Side& side : same) {
      if (turning_[side.name.item] != 0) outer.push_back(side.name);
    }
    if (outer.size() != before + 2) return;
    const LineName one = outer[before], other = outer[before + 1];
    if (start_of(one) != end_of(other)) return;
    sets_.join(one.item, other.item);
    outer.resize(before);
  }

  const Primitives& items_;
  const LineTable& scene_;
  SideTable table_;
  std::vector<std::int8_t> turning_;  // of the polygons that hide
  DisjointSets sets_;
  std::vector<OuterSide> outer_;  // in order
};

}  // namespace

ConvexObjects::ConvexObjects(const Primitives& items, const LineTable& scene) {
  Surfaces surfaces(items, scene);
  std::vector<std::uint32_t> hiding, outline;
  for (std::uint32_t i = 0; i < scene.items(); ++i) {
    if (scene.hides(i)) hiding.push_back(i);
  }
  std::ranges::stable_sort(hiding, {}, [&](std::uint32_t i) { return surfaces.set_of(i); });
  for (std::size_t from = 0; from < hiding.size();) {
    const std::uint32_t set = surfaces.set_of(hiding[from]);
    std::size_t to = from + 1;
    while (to < hiding.size() && surfaces.set_of(hiding[to]) == set) ++to;
    const auto polygons = std::span(hiding).subspan(from, to - from);
    if (polygons.size() > 1 && surfaces.find_outline(set, outline)) {
      add(polygons, outline, scene);
    } else {
      for (const std::uint32_t& polygon : polygons) add({&polygon, 1}, {}, scene);
    }
    from = to;
  }
  assert(polygons_.size() == hiding.size() && extents_.size() == objects_.size());
}

void ConvexObjects::add(std::span<const std::uint32_t> polygons,
                        std::span<const std::uint32_t> outline, const LineTable& scene) {
  objects_.push_back(
      {static_cast<std::uint32_t>(polygons_.size()), static_cast<std::uint32_t>(polygons.size()),
       static_cast<std::uint32_t>(outlines_.size()), static_cast<std::uint32_t>(outline.size())});
  Extent around = Extent::nothing();
  for (const std::uint32_t polygon : polygons) around.include(scene.extent(polygon));
  extents_.push_back(around);
  polygons_.insert(polygons_.end(), polygons.begin(), polygons.end());
  outlines_.insert(outlines_.end(), outline.begin(), outline.end());
}

}  // namespace displayfile
