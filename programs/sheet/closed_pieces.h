#pragma once

#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The faces of a mesh as objects, in their order: each ends as soon as it uses every side as often
/// in one direction as in the other, vertices of equal position being one. So closed pieces that
/// touch are objects of their own if they were entered one after another, as shapes and solids are.
/// What is left at the end, if that is not closed, is the last object.
std::vector<Mesh::Object> closed_pieces(const Mesh& mesh);

}  // namespace displayfile
