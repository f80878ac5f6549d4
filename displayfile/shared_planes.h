#pragma once

#include <vector>

#include "displayfile/retained_scene.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The plane that each primitive of a scene lies in with others, as they were entered
/// (hidden/touching_planes.md), in world coordinates: by the numbers of three of the scene's
/// points, as Primitives::planes has them. Empty if no two polygons lie in one plane.
std::vector<Primitives::PlanePoints> shared_planes(const RetainedScene& scene);

}  // namespace displayfile
