#pragma once

#include <utility>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// At 45 degrees.
inline constexpr Point2 kHatchingDirection{0.70710678118654752, 0.70710678118654752};

/// The interior of loops: points in an odd number of them, or points with a non-zero winding
/// number.
enum class WithinLoops { odd, wound };

/// Lines within loops, along a direction of length 1, at this spacing (in the units of the loops),
/// aligned so that one passes through the origin. There must be fewer than 2^53 of them.
std::vector<std::pair<Point2, Point2>> hatched_loops(const std::vector<std::vector<Point2>>& loops,
                                                     WithinLoops within, double spacing,
                                                     const Point2& direction);

}  // namespace displayfile
