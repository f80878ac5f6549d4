#include "programs/bench/triangles.h"

#include "clip/planarity.h"

namespace displayfile::bench {

Triangles in_triangles(const ViewedScene& scene) {
  Triangles triangles;
  triangles.corners.reserve(3 * std::size_t{scene.end()});
  Triangulation triangulation;
  for (ViewedScene::Fill fill = 1; fill < scene.end(); ++fill) {
    const auto p = scene.vertices(fill);
    if (p.size() == 3) {
      triangles.corners.insert(triangles.corners.end(), p.begin(), p.end());
      triangles.fills.push_back(fill);
      continue;
    }
    for (const Triangulation::Triangle& t : triangulation.triangulate(p)) {
      for (const std::uint32_t corner : t.vertex) triangles.corners.push_back(p[corner]);
      triangles.fills.push_back(fill);
    }
  }
  return triangles;
}

}  // namespace displayfile::bench
