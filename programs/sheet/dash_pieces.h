#pragma once

#include <vector>

#include "clip/point.h"

namespace displayfile {

/// The drawn parts of a dashed polyline; dashes continue through its vertices. `dashes` are lengths
/// drawn and skipped alternately, as in SheetPen, and not empty.
std::vector<std::vector<Point2>> dash_pieces(const std::vector<Point2>& points, bool closed,
                                             const std::vector<double>& dashes);

}  // namespace displayfile
