#pragma once

#include <utility>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// At 45 degrees.
inline constexpr Point2 kHatchingDirection{0.70710678118654752, 0.70710678118654752};

/// What is within loops: what lies in an odd number of them, or what they wind around, that is
/// counterclockwise more or less often than clockwise.
enum class WithinLoops { odd, wound };

/// Lines within loops, along a direction of length 1, so far apart (in the units of the loops): one
/// goes through the origin, or would. There must be fewer than 2^53 of them.
std::vector<std::pair<Point2, Point2>> hatched_loops(const std::vector<std::vector<Point2>>& loops,
                                                     WithinLoops within, double spacing,
                                                     const Point2& direction);

}  // namespace displayfile
