#pragma once

#include <string>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Reads a STEP or IGES file by OpenCASCADE, in this process, without protection from its faults;
/// files are read by read_by_cad_process (cad_import.h). An object is an instance of a part, named
/// by the part, placed as the assembly places it; lengths are in the file's unit. Curved surfaces
/// become triangles no farther from them than `deflection` (ImportLimits::deflection), and with no
/// more than 20 degrees between neighbours; a plane face without holes becomes one polygon.
/// Neighbouring faces share the vertices of their common edge. Throws Error, naming the file: it is
/// invalid, ends too early, or has no faces; std::bad_alloc.
Mesh read_cad_file(const std::string& path, bool with_normals, double deflection);

/// Prepares the library, so that it needs no file but the mesh.
void load_cad_library(const std::string& path);

}  // namespace displayfile
