#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "clip/angle.h"
#include "clip/back_face.h"
#include "clip/base/round_to_nearest.h"
#include "clip/corners.h"
#include "clip/unit.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/welded_faces.h"

namespace displayfile {

namespace {

/// The angle between the sides that meet in the corner; 0 if one has no length.
double angle_at(const Point3& corner, const Point3& before, const Point3& after) {
  return angle_between(before - corner, after - corner);
}

/// For each vertex, the sum of the normals of the faces around it, times their angles there.
std::vector<Point3> angle_weighted_normals(const WeldedFaces& faces) {
  std::vector<Point3> sum(faces.vertices.size(), Point3(0.0));
  std::vector<Point3> polygon;
  for (std::size_t i = 0; i < faces.faces(); ++i) {
    const auto face = faces.face(i);
    polygon.clear();
    for (const std::uint32_t v : face) polygon.push_back(faces.vertices[v]);
    const Point3 normal = newell_normal(polygon);
    if (normal == Point3(0.0)) continue;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Point3& before = polygon[previous_corner(k, polygon.size())];
      const Point3& after = polygon[next_corner(k, polygon.size())];
      sum[face[k]] += angle_at(polygon[k], before, after) * unit(normal);
    }
  }
  return sum;
}

}  // namespace

void complete_normals(Mesh& mesh) {
  const RoundToNearest nearest;
  mesh.corner_normals.resize(mesh.corners.size(), Mesh::kNoNormal);
  const WeldedFaces faces = weld(mesh, entered_reach(mesh));
  const std::vector<Point3> around = angle_weighted_normals(faces);
  const auto first = static_cast<std::uint32_t>(mesh.normals.size());
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    if (mesh.normal(k) == Point3(0.0)) mesh.corner_normals[k] = first + faces.corners[k];
  }
  mesh.normals.insert(mesh.normals.end(), around.begin(), around.end());
}

}  // namespace displayfile
