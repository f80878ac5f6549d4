#pragma once

#include <span>

#include "clip/point.h"

namespace displayfile {

/// A polygon counts as flat if no vertex lies farther from its plane than this times the
/// largest side of its bounding box. (Mesh files often hold single-precision coordinates.)
inline constexpr double kFlatnessTolerance = 1e-6;

/// True if the polygon (world coordinates) is flat within kFlatnessTolerance. A polygon
/// without area counts as flat. The plane goes through the vertices' mean, normal by Newell.
bool is_flat(std::span<const Point3> world);

}  // namespace displayfile
