#pragma once

#include <span>

#include "clip/point.h"
#include "programs/sheet/drawing_sheet.h"

namespace displayfile {

/// Removes the parts of the sheet's lines inside a convex polygon, counterclockwise, in mm: the
/// polygon covers what was drawn before it.
void remove_lines_within(std::span<const Point2> polygon, DrawingSheet& sheet);

}  // namespace displayfile
