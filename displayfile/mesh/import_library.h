#pragma once

#include <optional>
#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Reads a mesh of any format that Assimp supports, in this process, without protection from the
/// library's faults; meshes are read by read_by_import_process (import_process.h). The library is
/// loaded on first use and opens only the mesh's neighbours (neighbour_files.h). Coordinates have
/// its single precision. An object is a node of the file's scene that has faces; its transformation
/// is applied, and mirrored faces stay outward. Throws Error: the library is not built in or not
/// installed; no reader supports the format; or the file is bad, with the message of the reader for
/// its extension. Some readers write to std::cerr themselves.
Mesh read_by_import_library(const std::string& path, bool with_normals);

/// Loads the library in advance. Throws Error, naming the path, if it cannot be loaded.
void load_import_library(const std::string& path);

/// The version of the library, which it loads; nothing if there is none.
std::optional<std::string> import_library_version();

/// The extensions that the library reads, with their dots, unordered. Loads the library; empty if
/// there is none.
std::vector<std::string> import_library_extensions();

}  // namespace displayfile
