#pragma once

#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// A mesh file in a format with a built-in reader, its whole content in memory.
struct MeshFile {
  std::string path;
  std::string data;
  bool with_normals = false;  ///< read vertex normals, if the file has them
};

/// Built-in readers. Each throws Error with file, line and column (text) or file and element number
/// (binary), and what was expected. Announced counts are limited by the bytes that follow.
Mesh read_obj(const MeshFile& file);
Mesh read_off(const MeshFile& file);
Mesh read_ply(const MeshFile& file);
Mesh read_stl(const MeshFile& file);

/// The extensions of built-in readers, with dots.
std::vector<std::string> extensions_read_here();

}  // namespace displayfile
