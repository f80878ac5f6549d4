#include "displayfile/mesh/formats_beside_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <iterator>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/gltf_accessors.h"
#include "displayfile/mesh/gltf_json.h"
#include "displayfile/mesh/gltf_part.h"
#include "displayfile/mesh/gltf_scene.h"
#include "displayfile/mesh/mesh_builder.h"

namespace displayfile {

namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";
constexpr const char* kInstances = "EXT_mesh_gpu_instancing";
constexpr const char* kVariants = "KHR_materials_variants";
constexpr const char* kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

/// True for extensions that are read, or that change neither faces nor their base colours.
bool is_read(std::string_view extension) {
  constexpr std::string_view kRead[] = {kDraco,
                                        kInstances,
                                        "KHR_mesh_quantization",
                                        "KHR_animation_pointer",
                                        "KHR_lights_punctual",
                                        "KHR_materials_anisotropy",
                                        "KHR_materials_clearcoat",
                                        "KHR_materials_dispersion",
                                        "KHR_materials_emissive_strength",
                                        "KHR_materials_ior",
                                        "KHR_materials_iridescence",
                                        kSpecularGlossiness,
                                        "KHR_materials_sheen",
                                        "KHR_materials_specular",
                                        "KHR_materials_transmission",
                                        "KHR_materials_unlit",
                                        kVariants,
                                        "KHR_materials_volume",
                                        "KHR_texture_basisu",
                                        "KHR_texture_transform",
                                        "KHR_xmp_json_ld",
                                        "EXT_texture_avif",
                                        "EXT_texture_webp",
                                        "MSFT_texture_dds"};
  return std::ranges::find(kRead, extension) != std::end(kRead);
}

const Json& extension(const Json& object, const char* name) {
  return object_in(object_in(object, "extensions"), name);
}

bool is_read_by_import_library(const Json& file) {
  if (!text_of(member(member(file, "asset"), "version")).starts_with("2.")) return true;
  return std::ranges::any_of(member(file, "meshes"), [](const Json& mesh) {
    return std::ranges::any_of(member(mesh, "primitives"), [](const Json& primitive) {
      return !extension(primitive, kDraco).is_null();
    });
  });
}

/// A material, and whether vertex opacity applies to it.
struct GltfMaterial {
  Mesh::Material material{Colour(1.0)};
  bool is_blended = false;
};

GltfMaterial material_of(const Json& material) {
  const Json& metallic = object_in(material, "pbrMetallicRoughness");
  const Json& glossy = extension(material, kSpecularGlossiness);
  constexpr std::array kWhite{1.0, 1.0, 1.0, 1.0};
  const auto c = glossy.is_null() ? numbers_in(metallic, "baseColorFactor", kWhite)
                                  : numbers_in(glossy, "diffuseFactor", kWhite);
  const std::string_view mode = text_of(member(material, "alphaMode"));
  GltfMaterial read;
  read.material.colour = brought_into_range(Colour(c[0], c[1], c[2]));
  read.material.textured = !object_in(metallic, "baseColorTexture").is_null() ||
                           !object_in(glossy, "diffuseTexture").is_null();
  read.is_blended = mode == "BLEND";
  const double cutoff = number_in(material, "alphaCutoff", 0.5);
  read.material.transparent = (read.is_blended && c[3] < 1.0) || (mode == "MASK" && c[3] < cutoff);
  return read;
}

class GltfReader {
 public:
  GltfReader(const std::string& path, bool with_normals, const GltfFile& file)
      : json_(file.json),
        with_normals_(with_normals),
        accessors_(path, file),
        scene_(path, file.json),
        mesh_(path) {
    mesh_.set_single_precision();
  }

  Mesh read() && {
    for (const Json& material : array_in(json_, "materials")) {
      materials_.push_back(material_of(material));
    }
    materials_.emplace_back();  // that of parts without any
    for (const GltfMaterial& m : materials_) mesh_.add_material(m.material);
    for (const std::size_t node : scene_.nodes()) add_node(node);
    mesh_.warn_left_out(scene_.meshes_elsewhere(), "{} object that is not in the scene",
                        "{} objects that are not in the scene");
    mesh_.warn_left_out(without_positions_, "{} primitive without positions",
                        "{} primitives without positions");
    mesh_.warn_left_out(array_in(json_, "animations").size(), "{} animation", "{} animations");
    mesh_.warn_left_out(array_in(extension(json_, kVariants), "variants").size(),
                        "{} variant of materials", "{} variants of materials");
    return std::move(mesh_).finish();
  }

 private:
  void add_node(std::size_t number) {
    const Json& node = member(json_, "nodes")[number];
    const Json& mesh = referred(array_in(json_, "meshes"), member(node, "mesh"));
    if (member(node, "mesh").is_null()) return;
    if (mesh.is_null()) {
      throw std::runtime_error(
          fmt::format("glTF: mesh {}: there is none", member(node, "mesh").dump()));
    }
    const std::string_view name = text_of(member(node, "name"));
    mesh_.begin_object(name.empty() ? text_of(member(mesh, "name")) : name);
    const std::vector<double> weights = weights_of(node, mesh);
    const std::vector<glm::dmat4> joints = joints_of(node), places = places_of(node, number);
    for (const Json& primitive : array_in(mesh, "primitives")) {
      const GltfPart part = read_gltf_part(primitive, weights, with_normals_, accessors_);
      use_material(primitive);
      without_positions_ += part.positions.empty() ? 1 : 0;
      GltfPart skinned = part;
      if (!joints.empty() && move_by_skin(primitive, joints, accessors_, skinned)) {
        add(skinned);
        continue;
      }
      for (const glm::dmat4& place : places) {
        GltfPart placed = part;
        move_part(place, placed);
        add(placed);
      }
    }
  }

  /// Weights of a mesh's morph targets in a node.
  static std::vector<double> weights_of(const Json& node, const Json& mesh) {
    const Json& own = array_in(node, "weights");
    const Json& in_force = own.is_null() ? array_in(mesh, "weights") : own;
    std::vector<double> weights;
    for (const Json& weight : in_force) weights.push_back(weight.get<double>());
    return weights;
  }

  /// For each joint of the node's skin, the transformation from the mesh to the world.
  std::vector<glm::dmat4> joints_of(const Json& node) {
    std::vector<glm::dmat4> joints;
    const Json& skin = referred(array_in(json_, "skins"), member(node, "skin"));
    if (member(node, "skin").is_null()) return joints;
    if (skin.is_null()) {
      throw std::runtime_error(
          fmt::format("glTF: skin {}: there is none", member(node, "skin").dump()));
    }
    for (const Json& joint : array_in(skin, "joints")) {
      const auto number = whole_number(joint);
      if (!number || *number >= member(json_, "nodes").size()) {
        throw std::runtime_error(fmt::format("glTF: joint {}: expected a node", joint.dump()));
      }
      joints.push_back(scene_.to_world(*number));
    }
    const Json& inverse = member(skin, "inverseBindMatrices");
    if (inverse.is_null()) return joints;
    const GltfValues matrices = accessors_.values(inverse, 16);
    if (matrices.count < joints.size()) {
      throw std::runtime_error(fmt::format("glTF: {} inverse bind matrices for {} joints",
                                           matrices.count, joints.size()));
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      glm::dmat4 bound(1.0);
      for (int k = 0; k < 16; ++k) bound[k / 4][k % 4] = matrices[i][k];
      joints[i] = joints[i] * bound;
    }
    return joints;
  }

  /// The transformations of a node's mesh to the world: one, or one for each instance.
  std::vector<glm::dmat4> places_of(const Json& node, std::size_t number) {
    const glm::dmat4& to_world = scene_.to_world(number);
    const Json& attributes = object_in(extension(node, kInstances), "attributes");
    if (attributes.empty()) return {to_world};
    const auto values = [&](const char* name, std::size_t components) {
      const Json& reference = member(attributes, name);
      return reference.is_null() ? GltfValues{} : accessors_.values(reference, components);
    };
    const GltfValues moved = values("TRANSLATION", 3), turned = values("ROTATION", 4),
                     scaled = values("SCALE", 3);
    const std::size_t count = std::max({moved.count, turned.count, scaled.count});
    for (const GltfValues* each : {&moved, &turned, &scaled}) {
      if (each->count != 0 && each->count != count) {
        throw std::runtime_error("glTF: attributes of instances: expected as many of each");
      }
    }
    std::vector<glm::dmat4> places;
    for (std::size_t i = 0; i < count; ++i) {
      std::array<double, 3> translation{}, scale{1.0, 1.0, 1.0};
      std::array<double, 4> rotation{0.0, 0.0, 0.0, 1.0};
      if (moved.count > 0) std::copy_n(moved[i], 3, translation.begin());
      if (turned.count > 0) std::copy_n(turned[i], 4, rotation.begin());
      if (scaled.count > 0) std::copy_n(scaled[i], 3, scale.begin());
      places.push_back(to_world * gltf_placement(translation, rotation, scale));
    }
    return places;
  }

  void use_material(const Json& primitive) {
    const Json& material = member(primitive, "material");
    const std::size_t none = materials_.size() - 1;
    material_ = material.is_null() ? none : whole_number(material).value_or(none);
    if (material_ >= none && !material.is_null()) {
      throw std::runtime_error(fmt::format("glTF: material {}: there is none", material.dump()));
    }
    mesh_.use_material(static_cast<std::uint32_t>(material_));
  }

  void add(const GltfPart& part) {
    const auto first_vertex = static_cast<std::uint32_t>(mesh_.vertices());
    const auto first_normal = static_cast<std::uint32_t>(mesh_.normals());
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
      const Point3& p = part.positions[i];
      if (!in_range(p)) {
        throw std::runtime_error(fmt::format(
            "glTF: vertex {} is ({}, {}, {}): expected finite coordinates", i, p.x, p.y, p.z));
      }
      mesh_.add_vertex(p);
      if (part.colours.empty()) continue;
      Rgba colour = part.colours[i];
      if (!materials_[material_].is_blended) colour.a = kOpaque;
      mesh_.add_vertex_colour(colour);
    }
    for (const Point3& normal : part.normals) mesh_.add_normal(normal);
    std::array<std::uint32_t, 3> corners{}, normals{};
    for (std::size_t i = 0; i + 2 < part.corners.size(); i += 3) {
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = first_vertex + part.corners[i + k];
        normals[k] = part.normals.empty() ? Mesh::kNoNormal : first_normal + part.corners[i + k];
      }
      if (with_normals_) {
        mesh_.add_face(corners, normals);
      } else {
        mesh_.add_face(corners);
      }
    }
    mesh_.skip_points_and_lines(part.points_and_lines);
    mesh_.note_rounding(part.rounding);
  }

  const Json& json_;
  bool with_normals_;
  GltfAccessors accessors_;
  GltfScene scene_;
  MeshBuilder mesh_;
  std::vector<GltfMaterial> materials_;  // the last for primitives without any
  std::size_t material_ = 0;             // of the part that is added
  std::size_t without_positions_ = 0;    // primitives
};

}  // namespace

std::optional<Mesh> read_gltf(const std::string& path, bool with_normals) {
  const GltfFile file = gltf_file(path);
  if (is_read_by_import_library(file.json)) return std::nullopt;
  require_extensions(path, file.json, is_read);
  try {
    return GltfReader(path, with_normals, file).read();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {  // of the JSON's types too
    throw Error(fmt::format("{}: not a mesh that can be read: {}", path, e.what()));
  }
}

}  // namespace displayfile
