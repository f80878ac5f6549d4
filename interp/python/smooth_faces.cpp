#include "interp/python/smooth_faces.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "displayfile/mesh/mesh.h"

namespace displayfile::python {

bool shades_smoothly(const GraphicsSystem& system) {
  const Attributes& attributes = system.looks().attributes;
  const bool is_lit = attributes.light && attributes.light->ambient < 1.0;
  return is_lit && attributes.shading != Shading::flat;
}

std::vector<Point3> corner_normals(const ManyPolygons& faces, const GraphicsSystem& system) {
  Mesh mesh;
  mesh.vertices.assign(faces.vertices.begin(), faces.vertices.end());
  mesh.corners.assign(faces.corners.begin(), faces.corners.end());
  const std::size_t count = faces.sides.empty() ? mesh.corners.size() / 3 : faces.sides.size();
  mesh.first_corner.reserve(count + 1);
  std::size_t first = 0;
  for (std::size_t i = 0; i < count; ++i) {
    mesh.first_corner.push_back(first);
    first += faces.sides.empty() ? 3 : faces.sides[i];
  }
  mesh.first_corner.push_back(first);
  mesh.objects.push_back({{}, 0, count});
  complete_normals(mesh, system);
  std::vector<Point3> normals;
  normals.reserve(mesh.corners.size());
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) normals.push_back(mesh.normal(k));
  return normals;
}

void enter_faces(GraphicsSystem& system, const ManyPolygons& faces) {
  const bool are_smooth = shades_smoothly(system) && faces.normals.empty() &&
                          !faces.corners.empty() &&
                          std::ranges::all_of(faces.vertices, in_range);  // or they are refused
  if (!are_smooth) return system.polygons_abs_3(faces);
  const std::vector<Point3> normals = corner_normals(faces, system);
  std::vector<Point3> vertices;  // one for each corner: its faces may have different normals
  vertices.reserve(faces.corners.size());
  for (const std::uint32_t corner : faces.corners) vertices.push_back(faces.vertices[corner]);
  std::vector<std::uint32_t> corners(vertices.size());
  std::iota(corners.begin(), corners.end(), 0U);
  std::vector<Colour> colours;
  if (!faces.vertex_colours.empty()) {
    for (const std::uint32_t corner : faces.corners) {
      colours.push_back(faces.vertex_colours[corner]);
    }
  }
  ManyPolygons separate = faces;
  separate.vertices = vertices;
  separate.corners = corners;
  separate.normals = normals;
  separate.vertex_colours = colours;
  system.polygons_abs_3(separate);
}

}  // namespace displayfile::python
