#pragma once

#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Reads a STEP or IGES file by OpenCASCADE, in a process of its own (import_process.md): each
/// surface becomes facets, no farther from it than limits.deflection. Throws Error, naming the
/// file, as read_by_import_process does; or if this build has no OpenCASCADE.
Mesh read_by_cad_process(const std::string& path, bool with_normals, const ImportLimits& limits);

/// The extensions that this build reads by OpenCASCADE, with their dots; empty without it.
std::vector<std::string> cad_extensions_read();

}  // namespace displayfile
