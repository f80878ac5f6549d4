#pragma once

#include <utility>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// Lines at 45 degrees, so far apart, within loops taken even-odd.
std::vector<std::pair<Point2, Point2>> section_hatching(
    const std::vector<std::vector<Point2>>& loops, double spacing);

}  // namespace displayfile
