#pragma once

#include <map>
#include <utility>
#include <vector>

#include "clip/geometry/corners.h"
#include "hidden/boxes/extents.h"
#include "hidden/exact/support_plane.h"
#include "hidden/sort/compare_polys.h"
#include "hidden/sort/hidden_surface_sort.h"
#include "hidden/sort/overlap.h"
#include "hidden/sort/touching_vertices.h"

namespace displayfile {

/// The coordinates of the items: device, or world before viewing.
enum class SortSpace : std::uint8_t { device, world };

/// Input of the object-space methods: the items as entries of the polygon table. In device
/// coordinates the planes are oriented so that the front is the viewer's side; in world coordinates
/// there is no viewer yet.
template <class Policy>
struct SortTables {
  using Index = PolygonTable::Index;

  SortTables(const Primitives& items_, const Policy& policy, SortSpace space_ = SortSpace::device)
      : items(items_), space(space_), vertices(items_.points, planes_of(items_, space_), policy) {
    if (vertices_touch(items_.touching)) vertices.set_touching(items_.touching);
    save_items();
    find_shared_planes();
  }

  const Primitives& items;
  SortSpace space;
  PolygonTable table;
  VertexTable<Policy> vertices;
  ComparePolys<Policy> comparing{table, vertices};
  std::vector<Index> degenerate;  ///< entries that hide nothing and are invisible

  bool hides(Index entry) const {
    return items.items[table[entry].item].kind == Primitives::Kind::solid &&
           table[entry].plane != kNoPlane;
  }
  Extent extent(Index entry) const {
    Extent box = Extent::nothing();
    for (const std::uint32_t v : table.vertices(entry)) {
      const auto [p, radius] = vertices.near(v);
      box.include(p, radius);
    }
    return box;
  }
  Outline outline(Index entry) const {
    const auto v = table.vertices(entry);
    return {v, v.size() == 2 ? 0 : convex_turning(vertices, v)};
  }
  /// The order of entry; of coplanar items, lines come last.
  bool entered_before(Index a, Index b) const {
    const bool line_a = table[a].sides == 2, line_b = table[b].sides == 2;
    if (line_a != line_b) return line_b;
    return table[a].item != table[b].item ? table[a].item < table[b].item : a < b;
  }

 private:
  /// The vertices that define the polygon's plane. A polygon that is edge-on, or collinear in world
  /// coordinates, has no plane.
  static SupportVertices plane_vertices(std::span<const Point3> points, SortSpace space) {
    return space == SortSpace::device ? support_vertices(points) : spread_vertices(points);
  }

  /// A plane for each polygon that has one, in order of entry: a shared one (Primitives::planes),
  /// or its own.
  static std::vector<Plane> planes_of(const Primitives& all, SortSpace space) {
    std::vector<Plane> planes;
    planes.reserve(all.items.size());
    for (std::size_t i = 0; i < all.items.size(); ++i) {
      if (all.items[i].kind == Primitives::Kind::line) continue;
      const PointRow points = all.points_of(all.items[i]);
      const SupportVertices support = plane_vertices(points, space);
      if (support.edge_on) continue;
      const auto& [p, q, r] = support.index;
      std::array through{points[p], points[q], points[r]};
      if (!all.has_own_plane(i)) {
        for (std::size_t k = 0; k < 3; ++k) through[k] = all.points[all.planes[i][k]];
      }
      const Point3 rest = all.plane_rest(i);
      Plane plane(through[0], through[1], through[2], rest);
      if (space == SortSpace::device && facing(plane) < 0) {
        plane = Plane(through[0], through[2], through[1], {rest.x, rest.z, rest.y});
      }
      planes.push_back(plane);
    }
    return planes;
  }

  void save_items() {
    table.entries.reserve(items.items.size());
    table.d.reserve(items.all_corners());
    std::uint32_t next_plane = 0;
    for (std::uint32_t i = 0; i < items.items.size(); ++i) {
      const Primitives::Item& item = items.items[i];
      if (item.kind == Primitives::Kind::line) {
        save_line(i, items.point(item.first), items.point(item.first + 1), {.whole = true});
      } else if (plane_vertices(items.points_of(item), space).edge_on) {
        save_outline(i);
      } else {
        save_poly_for_hsc(i, next_plane++);
      }
    }
  }

  /// Each polygon has its own plane number; polygons that share a plane count as coplanar.
  void find_shared_planes() {
    if (items.planes.empty()) return;
    std::map<Primitives::PlanePoints, std::uint32_t> first_of;
    for (const PolygonTable::Entry& entry : table.entries) {
      if (entry.plane == kNoPlane || items.has_own_plane(entry.item)) continue;
      const auto first = first_of.try_emplace(items.planes[entry.item], entry.plane).first;
      vertices.share_plane(entry.plane, first->second);
    }
  }

  /// Algorithm 9.7, except for data that the items have already.
  void save_poly_for_hsc(std::uint32_t i, std::uint32_t plane) {
    const Primitives::Item& item = items.items[i];
    table.entries.push_back({table.d.free(), item.sides, i, plane});
    std::uint32_t from = items.point(item.first + item.sides - 1);
    for (std::uint32_t corner = item.first; corner < item.first + item.sides; ++corner) {
      const std::uint32_t to = items.point(corner);
      table.d.put({vertices.enter(to, plane), SideLine::edge(from, to), items.visible_at(corner)});
      from = to;
    }
  }

  struct LineLook {
    bool whole = false;        ///< an item of two points, not a polygon's side
    std::uint8_t visible = 1;  ///< as Primitives::visible
  };
  void save_line(std::uint32_t i, std::uint32_t from, std::uint32_t to, const LineLook& look) {
    table.entries.push_back({table.d.free(), 2, i, kNoPlane});
    table.entries.back().whole = look.whole;
    table.d.put({from, SideLine::edge(to, from), 0});
    table.d.put({to, SideLine::edge(from, to), look.visible});
  }

  /// An edge-on polygon covers nothing; each drawn side becomes a line.
  void save_outline(std::uint32_t i) {
    const Primitives::Item& item = items.items[i];
    bool drawn = false;
    std::uint32_t from = item.sides == 0 ? 0 : items.point(item.first + item.sides - 1);
    for (std::uint32_t corner = item.first; corner < item.first + item.sides; ++corner) {
      const std::uint32_t to = items.point(corner);
      if (items.is_visible(corner)) {
        save_line(i, from, to, {.visible = items.visible_at(corner)});
        drawn = true;
      }
      from = to;
    }
    if (drawn) return;
    degenerate.push_back(table.free());
    table.entries.push_back({table.d.free(), 0, i, kNoPlane});
  }
};

/// The corner of the item, from 0, at which the side on that line ends. Searches from a corner on:
/// the sides of a piece are in the polygon's order.
inline std::uint32_t corner_of_side(const Primitives& items, const Primitives::Item& item,
                                    const SideLine& line, std::uint32_t look_from) {
  if (line.made_by_cut()) return SortedPieces::kNoCorner;
  for (std::uint32_t n = 0; n < item.sides; ++n) {
    const std::uint32_t k = (look_from + n) % item.sides;
    const std::uint32_t before = previous_corner(k, item.sides);
    if (items.point(item.first + k) == line.b && items.point(item.first + before) == line.a) {
      return k;
    }
  }
  return SortedPieces::kNoCorner;
}

/// The pieces of the entries, in that order, for the display file.
template <class Policy>
SortedPieces sorted_pieces(const SortTables<Policy>& scene,
                           std::span<const PolygonTable::Index> order, bool names_sides = false) {
  SortedPieces sorted;
  sorted.pieces.reserve(order.size() + scene.degenerate.size());
  const auto whole = [&](std::uint32_t item) {
    sorted.pieces.push_back({item, SortedPiece::kWhole, scene.items.items[item].sides});
  };
  // Pieces share the points of a cut; rounding is the expensive part.
  std::vector<std::pair<bool, Point3>> rounded(scene.vertices.made());
  const auto coordinates = [&](std::uint32_t v) {
    if (scene.vertices.is_entered(v)) return scene.vertices.entered(v);
    auto& [known, point] = rounded[scene.vertices.number_made(v)];
    if (!known) {
      known = true;
      point = scene.vertices.coordinates(v);
    }
    return point;
  };
  for (const PolygonTable::Index i : scene.degenerate) whole(scene.table[i].item);
  for (const PolygonTable::Index i : order) {
    const PolygonTable::Entry& entry = scene.table[i];
    if (entry.whole) {
      whole(entry.item);
      continue;
    }
    sorted.pieces.push_back(
        {entry.item, static_cast<std::uint32_t>(sorted.points.size()), entry.sides});
    std::uint32_t corner = 0;
    for (std::uint32_t k = 0; k < entry.sides; ++k) {
      const SideBuffer::Side side = scene.table.d[entry.start + k];
      sorted.points.push_back(coordinates(side.vertex));
      sorted.visible.push_back(side.visible);
      if (!names_sides) continue;
      const Primitives::Item& item = scene.items.items[entry.item];
      sorted.corners.push_back(corner_of_side(scene.items, item, side.line, corner));
      if (sorted.corners.back() != SortedPieces::kNoCorner) corner = sorted.corners.back();
    }
  }
  sorted.comparisons = scene.comparing.comparisons();
  sorted.cuts = scene.comparing.cuts();
  return sorted;
}

}  // namespace displayfile
