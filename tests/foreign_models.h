#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>

#include "tests/mesh_files.h"

// Models of formats that the import library reads, and a few that its readers do not stand.

namespace displayfile::test {

/// Two triangles with normals and a colour, the buffer in a file beside it.
inline std::string gltf(const std::string& buffer) {
  return fmt::format(R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0,1]}}],
      "nodes":[{{"mesh":0,"name":"near"}},{{"mesh":0,"name":"far","translation":[0,0,-4]}}],
      "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1}},"material":0}}]}}],
      "materials":[{{"pbrMetallicRoughness":{{"baseColorFactor":[0.75,0.125,0.5,1]}}}}],
      "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                     "min":[0,0,0],"max":[1,1,0]}},
                   {{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"}}],
      "bufferViews":[{{"buffer":0,"byteLength":36}},
                     {{"buffer":0,"byteOffset":36,"byteLength":36}}],
      "buffers":[{{"uri":"{}","byteLength":72}}]}})",
                     buffer);
}

inline std::string gltf_buffer() {
  std::string buffer;
  for (const float c : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) buffer += bytes(c);
  for (int i = 0; i < 3; ++i) buffer += bytes(0.0f) + bytes(0.6f) + bytes(0.8f);
  return buffer;
}

/// A triangle of three lines of coordinates.
inline std::string ac3d(const std::string& vertices) {
  return "AC3Db\nMATERIAL \"tiles\" rgb 0.75 0.25 0.125  amb 0.2 0.2 0.2  emis 0 0 0  "
         "spec 0.2 0.2 0.2  shi 10  trans 0\nOBJECT world\nkids 1\nOBJECT poly\nname \"roof\"\n"
         "numvert 3\n" +
         vertices + "numsurf 1\nSURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids 0\n";
}

/// Announces two thousand million objects, for which Assimp 5.2 makes room.
inline std::string ac3d_that_hungers() {
  return "AC3Db\nMATERIAL \"\" rgb 1 1 1  amb 0 0 0  emis 0 0 0  spec 0 0 0  shi 0  trans 0\n"
         "OBJECT world\nkids 2000000000\n";
}

/// Ends within a bone's name, whose end Assimp 5.2 looks for without an end.
inline std::string smd_that_hangs() { return "version 1\nnodes\n\"a"; }

/// A model of Half-Life whose tables lie a gigabyte behind the file's end, where Assimp 5.2 reads.
inline std::string mdl_that_crashes() {
  constexpr std::int32_t kFar = 0x40000000;
  std::string text = "IDST" + bytes(std::int32_t{10}) + "a" + std::string(63, '\0');
  text += bytes(std::int32_t{400}) + std::string(64, '\0');
  for (const std::int32_t n :
       {1, kFar, 0, 0, 0, 0, 1, 244, 1, 244, 1, kFar, kFar, 1, 1, 244, 1, kFar}) {
    text += bytes(n);
  }
  text.resize(400);
  return text;
}

}  // namespace displayfile::test
