// glTF: Khronos Group, "glTF 2.0 Specification", 2021.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "clip/base/error.h"
#include "displayfile/mesh/gltf_json.h"
#include "displayfile/mesh/import_losses.h"

namespace displayfile {

namespace {

/// Extensions that Assimp 5.2 reads, or that change neither faces nor their base colours.
constexpr std::array<std::string_view, 11> kReadExtensions{"KHR_draco_mesh_compression",
                                                           "KHR_lights_punctual",
                                                           "KHR_materials_clearcoat",
                                                           "KHR_materials_ior",
                                                           "KHR_materials_pbrSpecularGlossiness",
                                                           "KHR_materials_sheen",
                                                           "KHR_materials_specular",
                                                           "KHR_materials_transmission",
                                                           "KHR_materials_unlit",
                                                           "KHR_materials_volume",
                                                           "KHR_texture_transform"};

bool is_read_by_library(std::string_view extension) {
  return std::ranges::find(kReadExtensions, extension) != kReadExtensions.end();
}

/// Throws Error unless positions and normals are floats: the library would read integers' bytes as
/// floats.
void require_floats(const std::string& path, const Json& file) {
  constexpr int kFloat = 5126;
  for (const Json& mesh : member(file, "meshes")) {
    for (const Json& primitive : member(mesh, "primitives")) {
      for (const char* name : {"POSITION", "NORMAL"}) {
        const Json& reference = member(member(primitive, "attributes"), name);
        const Json& type = member(referred(member(file, "accessors"), reference), "componentType");
        if (!type.is_number() || type == kFloat) continue;
        throw Error(
            fmt::format("{}: {} of component type {}, which the glTF extension "
                        "KHR_mesh_quantization allows and which is not read: expected {}",
                        path, name, type.dump(), kFloat));
      }
    }
  }
}

bool has_other_than_zero(const Json& weights) {
  return std::ranges::any_of(weights, [](const Json& w) { return w.is_number() && w != 0; });
}

/// True if the node's mesh has morph targets that move its vertices before any animation.
bool is_morphed(const Json& node, const Json& mesh) {
  const Json& own = member(node, "weights");
  if (!has_other_than_zero(own.is_null() ? member(mesh, "weights") : own)) return false;
  return std::ranges::any_of(member(mesh, "primitives"), [](const Json& primitive) {
    return !member(primitive, "targets").empty();
  });
}

}  // namespace

ImportLosses losses_of_gltf(const std::string& path) {
  const Json file = gltf_file(path).json;
  require_extensions(path, file, is_read_by_library);
  require_floats(path, file);
  ImportLosses losses;
  losses.meant_names = meant_names(path, file);
  std::size_t morphed = 0, instanced = 0;
  for (const Json& node : member(file, "nodes")) {
    const Json& mesh = referred(member(file, "meshes"), member(node, "mesh"));
    if (mesh.is_null()) continue;
    morphed += is_morphed(node, mesh) ? 1 : 0;
    const Json& instances = member(member(node, "extensions"), "EXT_mesh_gpu_instancing");
    instanced += instances.is_null() ? 0 : 1;
  }
  losses.add(morphed, "the morph targets of {} object", "the morph targets of {} objects");
  losses.add(instanced, "the instances of {} object (EXT_mesh_gpu_instancing)",
             "the instances of {} objects (EXT_mesh_gpu_instancing)");
  return losses;
}

}  // namespace displayfile
