#pragma once

#include <vector>

#include "programs/sheet/part_drawing.h"

namespace displayfile {

/// The lines, in millimetres, without duplicates: touching or overlapping collinear lines are
/// merged, and hidden parts under visible lines removed. Ends are unchanged.
std::vector<PartDrawing::Line> unique_lines(const std::vector<PartDrawing::Line>& lines);

}  // namespace displayfile
