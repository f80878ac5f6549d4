#pragma once

#include <cstdint>

#include "programs/scenes/scene.h"

namespace displayfile {

/// A random degenerate scene: 2 to 12 polygons of 3 to 6 sides with coordinates from a tiny
/// grid, so that everything touches everything. The seed chooses the grid too: multiples of 1/8,
/// 1/6, 1/7 or 1/64 (at 32 x 32, the pixel centres among them) for x and y, 3 to 5 levels of z or
/// a plane common to all for the depth.
Scene random_degenerate_scene(std::uint64_t seed);

}  // namespace displayfile
