#pragma once

#include <vector>

#include "clip/point.h"

namespace displayfile {

/// What is drawn of a polyline in dashes that run on through its vertices. `dashes` are lengths
/// drawn, left out, and so on, as SheetPen has them, and not empty.
std::vector<std::vector<Point2>> dash_pieces(const std::vector<Point2>& points, bool closed,
                                             const std::vector<double>& dashes);

}  // namespace displayfile
