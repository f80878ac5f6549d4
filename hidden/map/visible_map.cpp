#include "hidden/map/visible_map.h"

#include <cassert>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "hidden/map/map_edges.h"
#include "hidden/map/map_vertices.h"

namespace displayfile {

namespace {

/// Numbers the vertices of edges, and notes those through which an edge may continue (join_edges).
void add_edges(const std::vector<MapEdge>& found, MapVertices& vertices, VisibleMap& map) {
  for (const MapEdge& edge : found) {
    const std::uint32_t from = vertices.number(edge.from, edge.at_from);
    const std::uint32_t to = vertices.number(edge.to, edge.at_to);
    assert(edge.left != edge.right);
    if (from != to) map.edges.push_back({from, to, edge.left, edge.right});
    if (edge.goes_on) vertices.note_touched(from);
  }
}

void join_edges(const std::vector<std::uint32_t>& touched, VisibleMap& map) {
  if (touched.empty()) return;
  assert(!map.edges.empty());
  std::vector<std::uint32_t> ends(map.points.size(), 0);
  for (const VisibleMap::Edge& edge : map.edges) {
    ++ends[edge.from];
    ++ends[edge.to];
  }
  std::vector<std::uint8_t> is_touched(map.points.size(), 0);
  for (const std::uint32_t vertex : touched) is_touched[vertex] = 1;
  std::size_t last = 0;
  for (std::size_t k = 1; k < map.edges.size(); ++k) {
    VisibleMap::Edge& before = map.edges[last];
    const VisibleMap::Edge& edge = map.edges[k];
    if (before.to == edge.from && is_touched[edge.from] != 0 && ends[edge.from] == 2) {
      before.to = edge.to;
    } else {
      map.edges[++last] = edge;
    }
  }
  map.edges.resize(last + 1);
}

void find_map(const MapTable& scene, const ContourEdges& ways, int threads, VisibleMap& map) {
  const std::vector<MapEdge> sides = edges_on_sides(scene, ways, threads);
  const std::vector<MapEdge> meetings = edges_of_meetings(scene, threads);
  MapVertices vertices(scene.lines, map, sides.size() + meetings.size());
  map.edges.reserve(sides.size() + meetings.size());
  add_edges(sides, vertices, map);
  add_edges(meetings, vertices, map);
  join_edges(vertices.touched(), map);
}

}  // namespace

VisibleMap visible_map(const Primitives& items, const MapOptions& options) {
  const NamedWork named({"the visible-surface map", "for pixels hidden-surface method z-buffer"});
  VisibleMap map;
  const LineTable scene(items, {}, options.threads);
  const SideTable sides(items);
  const ContourEdges ways(scene, items, sides, options.threads);
  CellGrid grid(scene, options.threads);
  if (options.shortcuts) grid.find_blocking_sheets(scene, ways, options.threads);
  const SeenFaces faces =
      options.shortcuts ? SeenFaces(scene, ways, grid, options.threads) : SeenFaces(scene);
  find_map({items, scene, sides, grid, faces}, ways, options.threads, map);
  map.whole.reserve(items.items.size());
  for (std::uint32_t i = 0; i < scene.items(); ++i) {
    map.whole.push_back(faces[i] == SeenFaces::Seen::whole ? 1 : 0);
  }
  return map;
}

}  // namespace displayfile
