#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/angle.h"
#include "clip/back_face.h"
#include "clip/base/round_to_nearest.h"
#include "clip/corners.h"
#include "clip/crease_angle.h"
#include "clip/unit.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/crease_normals.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/welded_faces.h"

namespace displayfile {

namespace {

constexpr std::string_view kHasNormals =
    "the crease angle has no effect: the file has normals of all vertices";

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

bool has_normal(const Mesh& mesh, std::size_t corner) { return mesh.normal(corner) != Point3(0.0); }

bool has_all_normals(const Mesh& mesh) {
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    if (!has_normal(mesh, k)) return false;
  }
  return true;
}

/// One for each corner, where the mesh has none.
void add_normals(std::span<const Point3> of_corners, Mesh& mesh) {
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    if (has_normal(mesh, k)) continue;
    mesh.corner_normals[k] = static_cast<std::uint32_t>(mesh.normals.size());
    mesh.normals.push_back(of_corners[k]);
  }
}

}  // namespace

void complete_normals(Mesh& mesh, double crease_degrees) {
  const RoundToNearest nearest;
  require_crease_angle(crease_degrees);
  mesh.corner_normals.resize(mesh.corners.size(), Mesh::kNoNormal);
  if (has_all_normals(mesh)) return;
  const double reach = entered_reach(mesh);
  WeldedFaces faces = weld(mesh, reach);
  if (crease_degrees < kNoCrease) {
    return add_normals(crease_normals(std::move(faces), reach, CreaseAngle(crease_degrees)), mesh);
  }
  const std::vector<Point3> around = angle_weighted_normals(faces);
  const auto first = static_cast<std::uint32_t>(mesh.normals.size());
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    if (!has_normal(mesh, k)) mesh.corner_normals[k] = first + faces.corners[k];
  }
  mesh.normals.insert(mesh.normals.end(), around.begin(), around.end());
}

void complete_normals(Mesh& mesh, const GraphicsSystem& system) {
  mesh.corner_normals.resize(mesh.corners.size(), Mesh::kNoNormal);
  if (system.explicit_settings().contains(Setting::crease_angle) && has_all_normals(mesh)) {
    mesh.skipped.warnings.emplace_back(kHasNormals);
  }
  complete_normals(mesh, system.crease_degrees());
}

}  // namespace displayfile
