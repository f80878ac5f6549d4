#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/mesh_files.h"

namespace displayfile::test {

using Json = nlohmann::ordered_json;

/// A file of one triangle and its buffer, to which more is added.
struct Gltf {
  Json file = Json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
      "nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
      "accessors":[],"bufferViews":[],"buffers":[{}]})");
  std::string buffer;

  Gltf() {
    std::string corners;
    for (const float c : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) corners += bytes(c);
    add(corners, 5126, 3, "VEC3");
  }

  /// Returns the index of a new accessor of these bytes.
  std::size_t add(const std::string& data, int component_type, int count, const char* type) {
    file["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", data.size()}});
    file["accessors"].push_back({{"bufferView", file["bufferViews"].size() - 1},
                                 {"componentType", component_type},
                                 {"count", count},
                                 {"type", type}});
    buffer += data;
    buffer.resize((buffer.size() + 3) / 4 * 4);
    return file["accessors"].size() - 1;
  }
  Json& primitive() { return file["meshes"][0]["primitives"][0]; }

  /// The text of the file, with its buffer under this name.
  std::string text(const std::string& uri) {
    file["buffers"][0] = {{"byteLength", buffer.size()}, {"uri", uri}};
    return file.dump();
  }
  std::string binary() {
    file["buffers"][0] = {{"byteLength", buffer.size()}};
    std::string json = file.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto four = [](std::size_t n) { return bytes(static_cast<std::uint32_t>(n)); };
    return "glTF" + four(2) + four(28 + json.size() + buffer.size()) + four(json.size()) + "JSON" +
           json + four(buffer.size()) + std::string("BIN\0", 4) + buffer;
  }
};

}  // namespace displayfile::test
