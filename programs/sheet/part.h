#pragma once

#include <span>
#include <string>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The inputs as one mesh: the faces of meshes and what drawing programs draw of polygons, in the
/// coordinates of who stands before it: x to the right, y up, z toward the viewer. Its objects are
/// those of meshes, and closed_pieces of drawing programs. `up` is an axis as --up has it; empty:
/// as the first input's file says. Throws Error if there are no faces, and as read_mesh does.
Mesh read_part(std::span<const std::string> inputs, const std::string& up,
               const ImportLimits& limits);

}  // namespace displayfile
