#pragma once

#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// A mesh file of one of the formats that are read here, its whole content in memory.
struct MeshFile {
  std::string path;
  std::string data;
  bool with_normals = false;  ///< of the vertices, where the file has them
};

/// The readers. Each throws Error with file, line and column (text) or file and number of the
/// element (binary), and what was expected. What a header announces is believed only as far as the
/// bytes that follow can hold it.
Mesh read_obj(const MeshFile& file);
Mesh read_off(const MeshFile& file);
Mesh read_ply(const MeshFile& file);
Mesh read_stl(const MeshFile& file);

/// The extensions of their files, with the dots.
std::vector<std::string> extensions_read_here();

}  // namespace displayfile
