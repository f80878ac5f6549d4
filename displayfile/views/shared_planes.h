#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "displayfile/segments/retained_scene.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The plane that each primitive of a scene lies in with others, as they were entered
/// (hidden/touching/touching_planes.md), and that of those that are bent
/// (hidden/exact/bent_polygon.h), in world coordinates: by the numbers of three of the scene's
/// points, as Primitives::planes has them. Empty if no two polygons lie in one plane, and none is
/// bent.
std::vector<Primitives::PlanePoints> shared_planes(const RetainedScene& scene);

/// The support plane of a polygon as it was entered, by three of the scene's points. Nothing if
/// these are in line.
std::optional<Primitives::PlanePoints> support_plane(const RetainedScene& scene,
                                                     std::uint32_t primitive);

}  // namespace displayfile
