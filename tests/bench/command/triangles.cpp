#include "tests/bench/command/triangles.h"

#include <span>

#include "hidden/triangles/triangulation.h"

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

DisplayFile display_file_of(const Triangles& triangles) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(LineStyle{LineStyle::Kind::none});
  segment.set_style(FillStyle{FillStyle::Kind::solid});
  const std::vector<std::uint8_t> edges(3, 1);
  const std::span<const Point3> corners = triangles.corners;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    segment.enter_polygon(corners.subspan(i, 3), edges);
  }
  return file;
}

}  // namespace displayfile::bench
