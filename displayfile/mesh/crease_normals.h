#pragma once

#include <vector>

#include "clip/crease_angle.h"
#include "clip/point.h"
#include "displayfile/mesh/welded_faces.h"

namespace displayfile {

/// For each corner of the faces, the mean of the normals of the faces around its vertex that are
/// connected with its own by sides that end there and are no creases, weighted by their angles
/// there (displayfile/looks/gouraud.md). Faces that run the other way are reversed for it. Sides on
/// which others end, within reach, are shared with these; needles count for nothing. Of any length;
/// zero: the face's own normal, also where the mean is within CreaseAngle::kCoplanar of it.
std::vector<Point3> crease_normals(WeldedFaces faces, double reach, const CreaseAngle& crease);

}  // namespace displayfile
