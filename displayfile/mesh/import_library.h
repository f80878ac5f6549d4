#pragma once

#include <optional>
#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Reads a mesh of any format that Assimp knows, in this process: what the library does there, this
/// process suffers. read_by_import_process (import_process.h) is what meshes are read by. The
/// library is loaded when it is first asked for, and opens the mesh's neighbours alone
/// (neighbour_files.h).
/// Coordinates come in the single precision that it keeps. An object is a node of the file's scene
/// that has faces; its transformation is applied, and one that mirrors keeps faces turned outward.
/// Throws Error: the library was left out of this build or is not installed, the file is of an
/// format that no reader takes or bad; then the reason is that of the reader that its extension
/// names. Some readers write to std::cerr themselves.
Mesh read_by_import_library(const std::string& path, bool with_normals);

/// Loads the library, which reading a mesh of this path does otherwise. Throws Error, naming it, if
/// it cannot be.
void load_import_library(const std::string& path);

/// The version of the library, which is loaded for that; nothing if there is none.
std::optional<std::string> import_library_version();

/// The extensions, with their dots and in no order, of the files that the library reads; it is
/// loaded for that. None if there is none.
std::vector<std::string> import_library_extensions();

}  // namespace displayfile
