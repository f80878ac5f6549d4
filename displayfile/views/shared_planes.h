#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "displayfile/segments/retained_scene.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The plane that each primitive of a scene shares with others as entered
/// (hidden/touching/touching_planes.md), and that of bent ones (hidden/exact/entered_plane.h), in
/// world coordinates: by indices of three of the scene's points, as in Primitives::planes. Empty if
/// no two polygons are coplanar and none is bent.
std::vector<Primitives::PlanePoints> shared_planes(const RetainedScene& scene);

/// The support plane of a polygon as entered, by three of the scene's points. Nothing if these are
/// collinear.
std::optional<Primitives::PlanePoints> support_plane(const RetainedScene& scene,
                                                     std::uint32_t primitive);

}  // namespace displayfile
