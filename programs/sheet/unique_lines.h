#pragma once

#include <vector>

#include "programs/sheet/part_drawing.h"

namespace displayfile {

/// The lines, in millimetres, with none drawn twice: those along one line that touch or overlap
/// become one, and what of a hidden one is under a visible one is left out. Ends stay as they are.
std::vector<PartDrawing::Line> unique_lines(const std::vector<PartDrawing::Line>& lines);

}  // namespace displayfile
