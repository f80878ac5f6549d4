#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"
#include "tests/temporary_folder.h"

// Mesh files that tests write and read.

namespace displayfile::test {

/// A test of mesh files, written into a folder of its own.
class MeshFiles : public TemporaryFolder {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    return TemporaryFolder::file(name, text).string();
  }
  Mesh read(const std::string& name, const std::string& text) const {
    return read_mesh(file(name, text));
  }
};

/// The suite of meshes that are read, of the variety of formats, and of refused files.
class MeshTest : public MeshFiles {};

/// As they stand in a file of this machine.
inline std::string bytes(auto value) {
  const auto array = std::bit_cast<std::array<char, sizeof(value)>>(value);
  return {array.begin(), array.end()};
}

/// The corners of a tetrahedron, in OBJ.
inline constexpr const char* kFourCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

/// The corners of a cube from (x, 0, 0) to (x + 1, 1, 1): bit k of the index is coordinate k.
inline std::string cube_vertices(double x) {
  std::string text;
  for (int i = 0; i < 8; ++i) text += fmt::format("v {} {} {}\n", x + (i & 1), i >> 1 & 1, i >> 2);
  return text;
}

inline constexpr int kCubeFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

/// Its faces, the light ones out; `first` is the OBJ index of its first vertex.
inline std::string cube_faces(int first = 1, int faces = 6, int flipped = -1,
                              bool inside_out = false) {
  std::string text;
  for (int f = 0; f < faces; ++f) {
    std::vector<int> face(kCubeFaces[f], kCubeFaces[f] + 4);
    if (inside_out != (f == flipped)) std::ranges::reverse(face);
    text += fmt::format("f {} {} {} {}\n", face[0] + first, face[1] + first, face[2] + first,
                        face[3] + first);
  }
  return text;
}

inline std::string cube() { return cube_vertices(0) + cube_faces(); }

inline std::string two_cubes(double distance) {
  return "o near\n" + cube_vertices(0) + cube_faces() + "o far\n" + cube_vertices(distance) +
         cube_faces(9);
}

}  // namespace displayfile::test
