#pragma once

#include <cstddef>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// Faces of a mesh in a row.
struct MeshPiece {
  std::size_t first_face, faces;
  bool closed;  ///< uses every side as often in one direction as in the other
};

/// The faces of a mesh in pieces, in their order, vertices of equal position being one. Within each
/// object that is closed by itself, and within objects in a row that are not, taken together, a
/// piece ends as soon as it is closed: so closed pieces that touch are pieces of their own if they
/// were entered one after another, as shapes and solids are. What is left at the end of objects
/// that are not closed is a piece that is not.
std::vector<MeshPiece> closed_pieces(const Mesh& mesh);

}  // namespace displayfile
