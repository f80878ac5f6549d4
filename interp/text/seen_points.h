#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/segments/viewed_scene.h"

namespace displayfile {

/// How much nearer than a point a polygon must be to hide it, as a part of the depth of the view
/// volume, or of the point's own depth if that is more. The corner of a face, or a point that was
/// meant to lie on it, is not hidden by that face: viewing rounds both, and faces count as flat
/// within such a tolerance (clip/geometry/planarity.h).
inline constexpr double kOnSurface = 0x1p-20;  // about 1e-6

/// For each point (the scene's coordinates) 1 if it is visible, 0 if hidden (interp/truth/truth.md,
/// "Texts"): it is hidden if, all around it and arbitrarily close, solid polygons that are nearer
/// at it by more than kOnSurface cover. So a point behind the outline of a polygon is visible, and
/// one behind a shared edge of two polygons is hidden. A polygon does not hide its own vertices.
/// Decided exactly.
std::vector<std::uint8_t> points_seen(const ViewedScene& scene, std::span<const Point3> points);

}  // namespace displayfile
