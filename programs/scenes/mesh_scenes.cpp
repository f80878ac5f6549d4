#include "programs/scenes/mesh_scenes.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "clip/geometry/bounds.h"

namespace displayfile {

namespace {

MeshDirection corner(std::string_view name, const Point3& from) {
  const Point3 toward = glm::normalize(from);
  const Point3 right = glm::normalize(glm::cross(Point3(0, 1, 0), toward));
  return {name, right, glm::cross(toward, right), toward};
}

}  // namespace

const std::array<MeshDirection, 6>& mesh_directions() {
  static const std::array<MeshDirection, 6> all = {{
      {"front", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {"right", {0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
      {"above", {1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
      corner("corner", {3, 2, 4}),
      corner("corner behind", {-4, 1, -2}),
      corner("corner below", {1, -3, 2}),
  }};
  return all;
}

Scene mesh_scene(const Mesh& mesh, const MeshDirection& direction) {
  Bounds bounds;
  for (const std::uint32_t corner : mesh.corners) bounds.include(mesh.vertices[corner]);
  const Point3 middle = bounds.middle();
  const double scale = 0.98 / std::max(glm::length(bounds.high - bounds.low), 1e-300);
  Scene scene;
  std::vector<Point3> polygon;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    polygon.clear();
    for (const std::uint32_t corner : mesh.face(i)) {
      const Point3 v = scale * (mesh.vertices[corner] - middle);
      polygon.push_back(0.5 + Point3(glm::dot(v, direction.right), glm::dot(v, direction.up),
                                     glm::dot(v, direction.toward)));
    }
    scene.add(polygon);
  }
  return scene;
}

}  // namespace displayfile
