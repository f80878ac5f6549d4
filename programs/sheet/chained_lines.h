#pragma once

#include <vector>

#include "programs/sheet/drawing_sheet.h"
#include "programs/sheet/part_drawing.h"

namespace displayfile {

/// Lines in millimetres as polylines of the layers visible and hidden: two that end at the same
/// point, where no third of their kind does, are joined, so that dashes continue through the sides
/// of a curve.
std::vector<DrawingSheet::Line> chained_lines(const std::vector<PartDrawing::Line>& lines);

}  // namespace displayfile
