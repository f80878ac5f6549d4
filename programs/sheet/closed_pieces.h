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

/// Divides a mesh's faces into pieces, in order, with equal vertices merged. Within each object
/// that is closed by itself, and within consecutive open objects taken together, a piece ends as
/// soon as it is closed: so touching closed pieces that were entered one after another, such as
/// shapes and solids, are separate. The rest of open objects is an open piece.
std::vector<MeshPiece> closed_pieces(const Mesh& mesh);

}  // namespace displayfile
