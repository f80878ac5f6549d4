#include "hidden/map/visible_map.h"

#include "hidden/map/map_edges.h"
#include "hidden/map/map_precision.h"
#include "hidden/map/map_vertices.h"

namespace displayfile {

namespace {

template <class Policy>
void find_map(const MapScene& scene, const ContourEdges& ways, const Policy& policy, int threads,
              VisibleMap& map) {
  const std::vector<MapEdge> sides = edges_on_sides(scene, ways, policy, threads);
  const std::vector<MapEdge> meetings = edges_of_meetings(scene, policy, threads);
  MapVertices vertices(scene.lines, map, Policy::kExact, sides.size() + meetings.size());
  map.edges.reserve(sides.size() + meetings.size());
  for (const auto* edges : {&sides, &meetings}) {
    for (const MapEdge& edge : *edges) {
      const std::uint32_t from = vertices.number(edge.from, edge.at_from);
      const std::uint32_t to = vertices.number(edge.to, edge.at_to);
      if (from != to) map.edges.push_back({from, to, edge.left, edge.right});
    }
  }
}

}  // namespace

VisibleMap visible_map(const Primitives& items, const MapOptions& options) {
  VisibleMap map;
  const LineScene scene(items, {}, options.threads);
  const SideTable sides(items);
  const ContourEdges ways(scene, items, sides, options.threads);
  CellGrid grid(scene, options.threads);
  grid.find_blocking_sheets(scene, ways, options.threads);
  const SeenFaces faces(scene, ways, grid, options.threads);
  const MapScene all{items, scene, sides, grid, faces};
  const Definitions points{items.points, {}};
  if (options.precision.exact) {
    find_map(all, ways, ExactMap(points), options.threads, map);
  } else {
    find_map(all, ways, RoundoffMap(points, options.precision.roundoff), options.threads, map);
  }
  map.whole.reserve(items.items.size());
  for (std::uint32_t i = 0; i < scene.items(); ++i) {
    map.whole.push_back(faces[i] == SeenFaces::Seen::whole ? 1 : 0);
  }
  return map;
}

}  // namespace displayfile
