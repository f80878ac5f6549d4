#pragma once

#include <cstddef>

#include "displayfile/solids/exact_solid.h"
#include "displayfile/solids/solid_faces.h"

namespace displayfile {

/// Some faces of a solid, each with one loop, as triangles, whose source is the face.
BoundingTriangles triangles_of(const SolidFaces& solid, std::size_t first_face,
                               std::size_t end_face);

/// Converts a result to faces: all triangles of one source are one face with the source's
/// attributes. A side is drawn unless it separates faces of one polygon, or exactly coplanar faces
/// with equal attributes. The order of vertices and faces does not depend on the library.
SolidFaces combined_faces(const BoundingTriangles& result, const SolidFaces& sources);

}  // namespace displayfile
