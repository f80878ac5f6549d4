#pragma once

#include <array>
#include <vector>

#include "clip/point.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

/// The lines of one height on a surface's triangles, moved to another height: those of `levels`
/// heights that divide low to high evenly. A triangle with a corner at a height counts it as above.
std::vector<std::array<Point3, 2>> contour_lines(const SurfaceGrid& grid, double low, double high,
                                                 int levels, double drawn_at);

}  // namespace displayfile
