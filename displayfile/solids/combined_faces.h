#pragma once

#include <cstddef>

#include "displayfile/solids/exact_solid.h"
#include "displayfile/solids/solid_faces.h"

namespace displayfile {

/// Some faces of a solid, each of one loop, as triangles; the source of each is its face.
BoundingTriangles triangles_of(const SolidFaces& solid, std::size_t first_face,
                               std::size_t end_face);

/// What was made of solids, as faces again: all triangles of one source are one face, which looks
/// as its source does. A side is drawn unless what it parts are faces of one polygon, or, exactly
/// in one plane, faces that look the same. Vertices and faces are in an order that does not depend
/// on the library.
SolidFaces combined_faces(const BoundingTriangles& result, const SolidFaces& sources);

}  // namespace displayfile
