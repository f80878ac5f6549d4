#pragma once

#include <optional>
#include <string>

#include "clip/base/shared_library.h"
#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Reads a glTF 2.0 file, JSON or binary (.glb), in the precision of the file, its transformations
/// in double precision, at rest: README.md lists what is read. An object is a node with a mesh.
/// Nothing if the file is of another version, or has meshes compressed by Draco: both are left to
/// the import library. Throws Error: it requires an extension that is not read, as the
/// specification demands; invalid JSON; data that are not there.
std::optional<Mesh> read_gltf(const std::string& path, bool with_normals);

/// Reads a 3MF file in double precision, in the unit of its model: 3MF Consortium, "3D
/// Manufacturing Format, Core Specification & Reference Guide", 1.3, its Materials and Properties
/// Extension, 1.2, and its Production Extension, 1.1; README.md lists what is read. An object is an
/// object with a mesh where an item of the build, or a component, places it. `library` is the
/// import library, which contains the archive reader. Nothing if the archive is not 3MF. Throws
/// Error: it requires an extension that is not read, as the specification demands; its model is
/// missing, damaged or invalid.
std::optional<Mesh> read_three_mf(const std::string& path, const SharedLibrary& library);

}  // namespace displayfile
