#pragma once

#include <span>

#include "clip/point.h"

namespace displayfile {

/// A normal of the polygon, by Newell's sums (equation 9.3): its components are twice the
/// areas of the polygon's projections along x, y and z. Taken about the first vertex, which
/// leaves the sums what they are and spares small polygons far from the origin their
/// cancellation. Points out of the light face: the one from which the vertices run
/// counterclockwise.
Point3 newell_normal(std::span<const Point3> vertices);

/// BACK-FACE-CHECK (algorithm 9.3): true if the polygon, in device coordinates, turns its
/// dark face or its edge to the viewer.
bool is_back_face(std::span<const Point3> vertices);

/// The z component of newell_normal alone.
double newell_c(std::span<const Point3> vertices);

}  // namespace displayfile
