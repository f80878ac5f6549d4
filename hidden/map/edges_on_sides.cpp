#include <glm/common.hpp>
#include <span>

#include "clip/base/budgeted_work.h"
#include "clip/base/parallel.h"
#include "clip/base/work_budget.h"
#include "clip/geometry/corners.h"
#include "hidden/lines/visible_pieces.h"
#include "hidden/map/edges_along_line.h"
#include "hidden/map/map_edges.h"
#include "hidden/map/side_carrier.h"

namespace displayfile {

namespace {

using SameSides = std::span<const SideTable::Side>;

/// A side that polygons share, from its lower point to its higher one.
struct SharedSide {
  std::uint32_t low, high;
  SameSides same;
  bool is_edge = false;  ///< between two entirely visible polygons
};

SharedSide shared_side(const MapTable& map, SameSides same) {
  const auto [item, corner] = same.front().name;
  const std::uint32_t p = map.sides.vertex(map.lines.corner_point(item, corner));
  const std::uint32_t before = previous_corner(corner, map.lines.sides(item));
  const std::uint32_t q = map.sides.vertex(map.lines.corner_point(item, before));
  return {std::min(p, q), std::max(p, q), same, false};
}

/// 1 if a counted polygon has its inside left of the side, -1 if right, 0 if the polygon is not
/// counted.
int inside_of(const MapTable& map, const ContourEdges& ways, const SharedSide& side,
              const LineName& name) {
  const std::uint32_t end = map.sides.vertex(map.lines.corner_point(name.item, name.corner));
  return end == side.high ? ways.way(name.item) : -ways.way(name.item);
}

/// The edge formed by a whole side.
MapEdge whole_edge(const MapTable& map, const ContourEdges& ways, const SharedSide& side) {
  const Point2 low(map.lines.point(side.low)), high(map.lines.point(side.high));
  const std::uint32_t one = side.same[0].name.item, other = side.same[1].name.item;
  const bool is_left = inside_of(map, ways, side, side.same[0].name) > 0;
  return {MapPlace::at_point(side.low), MapPlace::at_point(side.high), low + 0.0, high + 0.0,
          is_left ? one : other,        is_left ? other : one};
}

/// Finds the edges on sides, one side at a time.
class SideFinder {
  using Edges = EdgesAlongLine<SideCarrier>;
  using Seen = SeenAlongLine<SideCarrier>;

 public:
  SideFinder(const MapTable& map, const ContourEdges& ways) : map_(map), ways_(ways), edges_(map) {}

  void find(const SharedSide& side, std::vector<MapEdge>& edges) {
    if (side.is_edge) return edges.push_back(whole_edge(map_, ways_, side));
    const Point3 &a = map_.lines.point(side.low), &b = map_.lines.point(side.high);
    const Extent box = Extent::between(glm::min(a, b), glm::max(a, b));
    if (map_.grid.hides(with_owners(box, side))) return;
    edges_.line().look_at(side.low, side.high);
    owners_.clear();
    for (const auto& [high, name] : side.same) {
      const bool is_known = !owners_.empty() && owners_.back() == name.item;
      if (map_.lines.hides(name.item) && !is_known) owners_.push_back(name.item);
    }
    edges_.begin(owners_, {side.low, side.high});
    edges_.seen().begin();
    for (const auto& [high, name] : side.same) begin_with_whole(side, name);
    for (const std::uint32_t item : owners_) {
      if (!map_.faces.is_all_seen(item)) edges_.add(item);
    }
    edges_.find(box, edges);
  }

 private:
  /// The box of a side, extended to the depths of its owners' planes.
  Extent with_owners(Extent box, const SharedSide& side) const {
    if (map_.lines.all_even()) return box;
    for (const auto& [high, name] : side.same) {
      if (ways_.is_even(name.item)) continue;
      box.z_max = std::max(box.z_max, map_.lines.extent(name.item).z_max);
    }
    return box;
  }
  /// An entirely visible polygon is visible along all of its sides.
  void begin_with_whole(const SharedSide& side, const LineName& name) {
    if (!map_.faces.is_all_seen(name.item)) return;
    const bool is_left = inside_of(map_, ways_, side, name) > 0;
    edges_.seen().begin_with(is_left ? Seen::kLeft : Seen::kRight, name.item, true);
    edges_.note_added(name.item);
  }

  const MapTable& map_;
  const ContourEdges& ways_;
  Edges edges_;
  std::vector<std::uint32_t> owners_;
};

/// The sides of polygons that may be visible, except those between two entirely visible polygons:
/// these are whole edges, and are added. Whole edges found near uneven polygons are added later, in
/// order of sides.
std::vector<SharedSide> sides_to_look_at(const MapTable& map, const ContourEdges& ways,
                                         std::vector<MapEdge>& edges) {
  using enum SeenFaces::Seen;
  std::vector<SharedSide> sides;
  map.sides.for_each_set([&](SameSides same) {
    bool any = false, all_whole = true, all_seen = true;
    for (const auto& [high, name] : same) {
      const SeenFaces::Seen seen = map.faces[name.item];
      any |= seen != nothing;
      all_whole &= seen == whole;
      all_seen &= seen == whole || seen == entire;
    }
    if (!any) return;
    SharedSide side = shared_side(map, same);
    const Point2 low(map.lines.point(side.low)), high(map.lines.point(side.high));
    if (low == high) return;
    side.is_edge = same.size() == 2 && all_seen;
    if (!side.is_edge || !all_whole) return sides.push_back(side);
    edges.push_back(whole_edge(map, ways, side));
  });
  return sides;
}

}  // namespace

std::vector<MapEdge> edges_on_sides(const MapTable& map, const ContourEdges& ways, int threads) {
  constexpr std::size_t kSidesOfAPart = 256;
  std::vector<MapEdge> edges;
  const std::vector<SharedSide> sides = sides_to_look_at(map, ways, edges);
  std::vector<Point2> places;
  places.reserve(sides.size());
  for (const SharedSide& side : sides) places.emplace_back(map.lines.point(side.low));
  const std::vector<std::uint32_t> order = map.grid.by_cell(places);
  // The edges found per part of that order, and the range of each side.
  std::vector<std::vector<MapEdge>> found((sides.size() + kSidesOfAPart - 1) / kSidesOfAPart);
  struct OfSide {
    std::uint32_t part, first, end;
  };
  std::vector<OfSide> of_sides(sides.size());
  const auto make_finder = [&] { return SideFinder(map, ways); };
  Finders finders(make_finder);
  PieceCount pieces(sides.size(), sizeof(MapEdge));
  in_parallel(threads, found.size(), [&](std::size_t part) {
    const std::size_t end = std::min(sides.size(), (part + 1) * kSidesOfAPart);
    finders.use([&](auto& finder) {
      for (std::size_t k = part * kSidesOfAPart; k < end; ++k) {
        OfSide& of_side = of_sides[order[k]];
        of_side.part = static_cast<std::uint32_t>(part);
        of_side.first = static_cast<std::uint32_t>(found[part].size());
        finder.find(sides[order[k]], found[part]);
        of_side.end = static_cast<std::uint32_t>(found[part].size());
      }
    });
    pieces.add(found[part].size());
  });
  for (const auto& [part, first, end] : of_sides) {
    edges.insert(edges.end(), found[part].begin() + first, found[part].begin() + end);
  }
  return edges;
}

}  // namespace displayfile
