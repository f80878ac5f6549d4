#pragma once

#include <vector>

#include "displayfile/graphics_system.h"

namespace displayfile::python {

/// True if faces entered now are shaded smoothly where they have normals of vertices: shading is
/// not flat, and there is light that does not leave colours as they are.
bool shades_smoothly(const GraphicsSystem& system);

/// Normals at the corners of the faces, by the rule of imported meshes and the crease angle in
/// force (displayfile/looks/gouraud.md); zero: the face's own. The faces must have 3 corners or
/// more, and their vertices coordinates in range. Its own normals do not count.
std::vector<Point3> corner_normals(const ManyPolygons& faces, const GraphicsSystem& system);

/// Enters the faces as polygons_abs_3 does; where they are shaded smoothly and have no normals,
/// with corner_normals.
void enter_faces(GraphicsSystem& system, const ManyPolygons& faces);

}  // namespace displayfile::python
