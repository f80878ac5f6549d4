#pragma once

#include <functional>
#include <map>
#include <string>

#include "displayfile/mesh/mesh.h"
#include "displayfile/mesh/mesh_file.h"

namespace displayfile {

/// Materials by their names.
using MaterialLibrary = std::map<std::string, Mesh::Material, std::less<>>;

/// Reads a material library of OBJ files (.mtl): of each material the diffuse colour Kd, brought
/// into [0,1]; whether it has a texture (map_Kd); whether it is transparent (d below 1, or Tr
/// above 0 and below 1 where there is no d, or map_d). One that is begun again goes on; of a value
/// that is given again the last holds. Throws Error with file, line and column: a number that is
/// none or is not finite, binary data.
MaterialLibrary read_material_library(const MeshFile& file);

}  // namespace displayfile
