// glTF: Khronos Group, "glTF 2.0 Specification", 2021.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "clip/base/error.h"
#include "displayfile/mesh/binary_values.h"
#include "displayfile/mesh/import_losses.h"
#include "displayfile/mesh/percent_encoding.h"

namespace displayfile {

namespace {

using Json = nlohmann::json;

/// That Assimp 5.2 reads, or that change nothing of faces and their base colours.
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

// ---- The JSON --------------------------------------------------------------------------

/// A member of an object; null if there is none. Iterating over null gives nothing.
const Json& member(const Json& object, const char* name) {
  static const Json none;
  if (!object.is_object()) return none;
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

/// What a number refers to in an array, or in glTF 1.0 a name in an object; null if nothing.
const Json& referred(const Json& among, const Json& reference) {
  if (reference.is_string()) return member(among, reference.get_ref<const std::string&>().c_str());
  if (!among.is_array() || !reference.is_number_unsigned()) return member({}, "");
  const auto index = reference.get<std::uint64_t>();
  return index < among.size() ? among[static_cast<std::size_t>(index)] : member({}, "");
}

/// The JSON of a file: all of it, or the first chunk of a binary file, which glTF 1.0 has at the
/// same place.
std::string json_text(const std::string& path) {
  constexpr std::size_t kHeader = 20, kLength = 12;  // bytes; where the chunk's length stands
  std::ifstream in(path, std::ios::binary);
  std::string text(kHeader, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() < kHeader || !text.starts_with("glTF")) {
    text.append(std::istreambuf_iterator<char>(in), {});
    return text;
  }
  const auto length =
      binary_value<std::uint32_t>(std::string_view(text).substr(kLength), std::endian::little);
  text.clear();
  constexpr std::size_t kPart = 1 << 16;  // the length is not believed
  while (text.size() < length && in) {
    const std::size_t had = text.size();
    text.resize(had + std::min<std::size_t>(kPart, length - had));
    in.read(text.data() + had, static_cast<std::streamsize>(text.size() - had));
    text.resize(had + static_cast<std::size_t>(in.gcount()));
  }
  while (text.ends_with('\0')) text.pop_back();  // some programs fill up chunks by zeros
  return text;
}

Json json_of(const std::string& path) {
  try {
    return Json::parse(json_text(path));
  } catch (const Json::parse_error& e) {
    throw Error(
        fmt::format("{}: not a mesh that can be read: glTF: bad JSON at byte {}", path, e.byte));
  }
}

// ---- What is not read ------------------------------------------------------------------

void require_read_extensions(const std::string& path, const Json& file) {
  std::vector<std::string> others;
  for (const Json& name : member(file, "extensionsRequired")) {
    if (!name.is_string()) continue;
    const auto& extension = name.get_ref<const std::string&>();
    if (std::ranges::find(kReadExtensions, extension) == kReadExtensions.end()) {
      others.push_back(extension);
    }
  }
  if (others.empty()) return;
  throw Error(fmt::format("{}: requires the glTF extension{} {}, which {} not read", path,
                          others.size() > 1 ? "s" : "", fmt::join(others, ", "),
                          others.size() > 1 ? "are" : "is"));
}

/// The library takes the bytes of integers for those of single precision.
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

/// Whether the node's mesh has morph targets, which move its vertices before any animation.
bool is_morphed(const Json& node, const Json& mesh) {
  const Json& own = member(node, "weights");
  if (!has_other_than_zero(own.is_null() ? member(mesh, "weights") : own)) return false;
  return std::ranges::any_of(member(mesh, "primitives"), [](const Json& primitive) {
    return !member(primitive, "targets").empty();
  });
}

/// Names of buffers' files; no others are opened.
std::map<std::string, std::string> meant_names(const std::string& path, const Json& file) {
  std::map<std::string, std::string> names;
  for (const Json& buffer : member(file, "buffers")) {
    const Json& uri = member(buffer, "uri");
    if (!uri.is_string()) continue;
    const auto& written = uri.get_ref<const std::string&>();
    if (written.starts_with("data:") || written.find('%') == written.npos) continue;
    const auto meant = percent_decoded(written);
    if (!meant) {
      throw Error(
          fmt::format("{}: buffer '{}': expected two hexadecimal digits, not 00, behind each %",
                      path, written));
    }
    names.emplace(written, *meant);
  }
  return names;
}

}  // namespace

ImportLosses losses_of_gltf(const std::string& path) {
  const Json file = json_of(path);
  require_read_extensions(path, file);
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
