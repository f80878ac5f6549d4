#include "displayfile/mesh/formats_beside_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/three_mf_model.h"
#include "displayfile/mesh/xml_tags.h"
#include "displayfile/mesh/zip_archive.h"

namespace displayfile {

namespace {

/// The name of the part that holds the model, without the leading slash; empty if there is none.
std::string model_part(const ZipArchive& archive) {
  constexpr std::string_view kModel =
      "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
  const std::string relationships = archive.content("_rels/.rels").value_or("");
  XmlTags tags(relationships);
  while (const XmlTag* tag = tags.next()) {
    if (tag->local_name() != "Relationship" || tag->value("Type") != kModel) continue;
    std::string_view target = tag->value("Target").value_or("");
    if (target.starts_with('/')) target.remove_prefix(1);
    return std::string(target);
  }
  return {};
}

class ThreeMfReader {
 public:
  ThreeMfReader(const std::string& path, const ZipArchive& archive)
      : path_(path), archive_(archive), mesh_(path) {}

  Mesh read(const std::string& root) && {
    ThreeMfModel& model = model_of(root);
    if (model.build.empty()) fail("its build has no items");
    for (const ThreeMfPlacement& item : model.build) place(root, model, item);
    const WrittenDigits& digits = findings_.digits;
    if (model.millimetres != 1.0) {
      mesh_.warn(
          fmt::format("left out: its unit, {}: --unit sets that of a sheet or scale", model.unit));
    }
    mesh_.note_rounding(digits.rounding() * largest_scale_);
    warn();
    return std::move(mesh_).finish();
  }

 private:
  /// An object waiting to be placed.
  struct Waiting {
    std::string part;
    const ThreeMfModel* model;
    const ThreeMfPlacement* placement;
    glm::dmat4 to_world;
    std::size_t depth;
  };

  ThreeMfModel& model_of(const std::string& part) {
    const auto known = models_.find(part);
    if (known != models_.end()) return known->second;
    const auto text = archive_.content(part);
    if (!text) fail(fmt::format("its model {} is not in it", part));
    try {
      return models_.emplace(part, read_three_mf_model(*text, mesh_, findings_)).first->second;
    } catch (const std::runtime_error& e) {
      throw Error(fmt::format("{}: {}", path_, e.what()));
    }
  }

  /// Adds the meshes of an item's object and of its components, in their order.
  void place(const std::string& root, const ThreeMfModel& model, const ThreeMfPlacement& item) {
    std::vector<Waiting> waiting{{root, &model, &item, glm::dmat4(1.0), 0}};
    while (!waiting.empty()) {
      const Waiting next = std::move(waiting.back());
      waiting.pop_back();
      const std::string part = next.placement->part.empty() ? next.part : next.placement->part;
      ThreeMfModel& its_model = model_of(part);
      const auto object = its_model.objects.find(next.placement->object);
      if (object == its_model.objects.end()) {
        fail(fmt::format("object {} is not in {}", next.placement->object, part));
      }
      constexpr std::size_t kDeepest = 1000;
      if (next.depth > kDeepest) {
        fail(fmt::format("object {} is a component of itself", object->first));
      }
      const double scale = its_model.millimetres / next.model->millimetres;
      glm::dmat4 to_world = next.to_world * next.placement->transformation;
      for (int column = 0; column < 3; ++column) to_world[column] *= scale;
      object->second.is_placed = true;
      add(object->second, to_world);
      const auto& components = object->second.components;
      for (std::size_t c = components.size(); c-- > 0;) {  // the first is placed first
        waiting.push_back({part, &its_model, &components[c], to_world, next.depth + 1});
      }
    }
  }

  void add(const ThreeMfObject& object, const glm::dmat4& to_world) {
    if (object.triangles.empty()) return;
    mesh_.begin_object(object.name);
    const auto first = static_cast<std::uint32_t>(mesh_.vertices());
    for (const Point3& vertex : object.vertices) {
      const Point3 p(to_world * HomogeneousPoint(vertex, 1.0));
      if (!in_range(p)) fail(fmt::format("object '{}' is placed out of range", object.name));
      mesh_.add_vertex(p);
    }
    const glm::dmat3 linear(to_world);
    for (int k = 0; k < 3; ++k) largest_scale_ = std::max(largest_scale_, glm::length(linear[k]));
    const bool mirrors = glm::determinant(linear) < 0.0;
    for (const ThreeMfTriangle& triangle : object.triangles) {
      const auto& [a, b, c] = triangle.corners;
      mesh_.use_material(triangle.material);
      mesh_.add_face(std::array{first + a, first + (mirrors ? c : b), first + (mirrors ? b : c)});
    }
  }

  void warn() {
    mesh_.warn_left_out(findings_.varied,
                        "the different colours of {} triangle's corners: their mean is drawn",
                        "the different colours of the corners of {} triangles: their mean is "
                        "drawn");
    mesh_.warn_left_out(findings_.layered,
                        "all but the first of the properties of {} triangle (multiproperties)",
                        "all but the first of the properties of {} triangles (multiproperties)");
    mesh_.warn_left_out(findings_.unknown,
                        "the colour of {} triangle, which the file does not define",
                        "the colours of {} triangles, which the file does not define");
    mesh_.warn_left_out(unplaced(), "{} object that the build does not place",
                        "{} objects that the build does not place");
    for (const auto& [name, count] : findings_.other_geometry) {
      mesh_.warn_left_out(count, fmt::format("{{}} {}", name), fmt::format("{{}} {}s", name));
    }
  }

  std::size_t unplaced() const {
    std::size_t n = 0;
    for (const auto& [part, model] : models_) {
      for (const auto& [id, object] : model.objects) {
        n += !object.is_placed && !object.triangles.empty() ? 1 : 0;
      }
    }
    return n;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("{}: not a mesh that can be read: 3MF: {}", path_, what));
  }

  const std::string& path_;
  const ZipArchive& archive_;
  MeshBuilder mesh_;
  ThreeMfFindings findings_;
  std::map<std::string, ThreeMfModel> models_;  // by their parts
  double largest_scale_ = 0.0;
};

}  // namespace

std::optional<Mesh> read_three_mf(const std::string& path, const SharedLibrary& library) {
  const ZipArchive archive(library, path);
  const std::string part = model_part(archive);
  if (part.empty()) return std::nullopt;
  return ThreeMfReader(path, archive).read(part);
}

}  // namespace displayfile
