#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Groups of at least two of these objects, connected by open sides: an object is in a group with
/// each other one that has an open side of the same ends, after vertices within reach are one and
/// such vertices along open sides are corners. Groups, and the objects of each, are in order.
std::vector<std::vector<std::size_t>> objects_that_meet(const Mesh& mesh,
                                                        std::span<const std::size_t> objects,
                                                        double reach);

/// A mesh of some objects of a mesh: their faces and vertices, and all materials.
Mesh mesh_of_objects(const Mesh& mesh, std::span<const std::size_t> objects);

}  // namespace displayfile
