#pragma once

#include <span>
#include <vector>

#include "clip/bounds.h"
#include "clip/surfaces.h"
#include "programs/sheet/part.h"
#include "programs/sheet/part_drawing.h"

namespace displayfile {

/// The box around the vertices that faces use.
Bounds bounds_of_used(const Mesh& mesh);

struct LinesWanted {
  LineSelection selection;
  int threads;
};
/// The lines of a part already in a view's coordinates; `caps` are polygons that hide what lies
/// behind them, and have no lines.
std::vector<PartDrawing::Line> lines_of_part(const Part& part,
                                             std::span<const std::vector<Point3>> caps,
                                             const LinesWanted& wanted);

}  // namespace displayfile
