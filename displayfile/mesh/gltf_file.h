#pragma once

#include <optional>
#include <string>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Reads a glTF 2.0 file, JSON or binary (.glb), in the precision of the file, its transformations
/// in double precision, at rest: README.md lists what is read. An object is a node with a mesh.
/// Nothing if the file is of another version, or has meshes compressed by Draco: both are left to
/// the import library. Throws Error: it requires an extension that is not read, as the
/// specification demands; invalid JSON; data that are not there.
std::optional<Mesh> read_gltf(const std::string& path, bool with_normals);

}  // namespace displayfile
