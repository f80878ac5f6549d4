#pragma once

#include <functional>
#include <map>
#include <string>

#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/mesh_file.h"

namespace displayfile {

/// Materials by their names.
using MaterialLibrary = std::map<std::string, Mesh::Material, std::less<>>;

/// Reads a material library of OBJ files (.mtl): for each material the diffuse colour Kd, clamped
/// to [0,1], unless it is black beside a texture; whether it has a texture (map_Kd); whether it is
/// transparent (d below 1, or Tr above 0 and below 1 without d, or map_d). A repeated material is
/// continued, and of repeated values the last holds. Throws Error with file, line and column: an
/// invalid or non-finite number, binary data.
MaterialLibrary read_material_library(const MeshFile& file);

}  // namespace displayfile
