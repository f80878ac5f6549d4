#include "displayfile/solids/open_solids.h"

#include <fmt/format.h>

#include <utility>

#include "clip/base/error.h"
#include "displayfile/solids/exact_solid.h"

namespace displayfile {

void OpenSolids::begin(SolidOperation operation) {
  if (levels_.size() == kDeepest) {
    throw Error(
        fmt::format("solids within solids: expected at most {}, a shape being one, too", kDeepest));
  }
  const std::size_t faces = collected_.faces.size();
  std::size_t loose_around = faces;
  if (!levels_.empty()) {
    Level& around = levels_.back();
    loose_around = around.first_loose;
    if (faces > around.first_loose) around.parts.push_back({around.first_loose, faces, {}});
    around.first_loose = faces;
  }
  levels_.push_back({operation, loose_around, faces, faces, {}});
}

void OpenSolids::add(const WorldPolygon& polygon, const Attributes& attributes,
                     std::uint32_t polygon_number) {
  if (collected_.attributes.empty() || collected_.attributes.back() != attributes) {
    collected_.attributes.push_back(attributes);
  }
  SolidFaces::Face face;
  face.normal = polygon.normal;
  face.pick = polygon.pick;
  face.attributes = static_cast<std::uint32_t>(collected_.attributes.size() - 1);
  face.polygon = polygon_number;
  face.smooth = !polygon.vertex_normals.empty();
  std::vector<SolidFaces::Corner> loop;
  std::size_t k = 0;
  for (const Point3& p : polygon.vertices) {
    SolidFaces::Corner corner{static_cast<std::uint32_t>(collected_.vertices.size()), 1};
    if (!polygon.edge_visible.empty()) corner.edge_visible = polygon.edge_visible[k];
    if (face.smooth) corner.normal = polygon.vertex_normals[k];
    collected_.vertices.push_back(p);
    loop.push_back(corner);
    ++k;
  }
  collected_.add_loop(loop);
  collected_.add(face);
}

std::vector<OpenSolids::Part> OpenSolids::parts_of_innermost() const {
  const Level& level = levels_.back();
  std::vector<Part> parts = level.parts;
  if (collected_.faces.size() > level.first_loose) {
    parts.push_back({level.first_loose, collected_.faces.size(), {}});
  }
  if (parts.empty()) throw Error("a solid of nothing: expected shapes or polygons before its end");
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].made) continue;
    const auto open = open_side(collected_, parts[k].first_face, parts[k].end_face);
    if (!open) continue;
    const auto& [a, b] = *open;
    throw Error(
        fmt::format("{} is not closed: its side from {:.6g} {:.6g} {:.6g} to {:.6g} {:.6g} {:.6g} "
                    "is no other polygon's, in the other direction: expected a closed set of "
                    "polygons",
                    name_of_part(k, parts.size()), a.x, a.y, a.z, b.x, b.y, b.z));
  }
  return parts;
}

std::string OpenSolids::name_of_part(std::size_t k, std::size_t parts) {
  return parts == 1 ? "the solid" : fmt::format("part {} of {} of the solid", k + 1, parts);
}

ExactSolid OpenSolids::exactly(const Part& part, const std::string& name) const {
  if (part.made) return *part.made;
  return {triangles_of(collected_, part.first_face, part.end_face), name};
}

std::optional<SolidFaces> OpenSolids::end() {
  std::vector<Part> parts = parts_of_innermost();
  Part whole = parts.front();
  if (parts.size() > 1) {
    ExactSolid solid = exactly(whole, name_of_part(0, parts.size()));
    for (std::size_t k = 1; k < parts.size(); ++k) {
      const std::string name = name_of_part(k, parts.size());
      solid = ExactSolid::combined(levels_.back().operation, solid, exactly(parts[k], name), name);
    }
    whole.made = std::move(solid);
  }
  if (levels_.size() > 1) {
    levels_.pop_back();
    levels_.back().parts.push_back(std::move(whole));
    levels_.back().first_loose = collected_.faces.size();
    return std::nullopt;
  }
  SolidFaces faces =
      whole.made ? combined_faces(whole.made->rounded(), collected_) : std::move(collected_);
  levels_.clear();
  collected_ = {};
  return faces;
}

void OpenSolids::discard() {
  const auto [operation, loose_around, faces, first_loose, parts] = std::move(levels_.back());
  levels_.pop_back();
  if (!levels_.empty() && loose_around < faces) {
    levels_.back().parts.pop_back();  // the polygons before it continue a part
    levels_.back().first_loose = loose_around;
  }
  collected_.faces.resize(faces);
  const std::size_t loops = collected_.first_loop(faces);
  collected_.end_corner.resize(loops);
  const std::size_t corners = loops == 0 ? 0 : collected_.end_corner.back();
  // Each collected corner has a vertex of its own.
  collected_.corners.resize(corners);
  collected_.vertices.resize(corners);
}

}  // namespace displayfile
