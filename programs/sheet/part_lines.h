#pragma once

#include <vector>

#include "clip/geometry/bounds.h"
#include "clip/surfaces.h"
#include "programs/sheet/part.h"
#include "programs/sheet/part_drawing.h"

namespace displayfile {

/// The box around the vertices that faces use.
Bounds bounds_of_used(const Mesh& mesh);

struct LinesWanted {
  LineSelection selection;
  bool hidden;  ///< hidden lines too
  int threads;
};
/// The faces where a part was cut: polygons that hide the lines behind them, and loops that are
/// lines.
struct CutFacesOfPart {
  std::vector<std::vector<Point3>> caps{}, outlines{};
};
/// The lines of a part already in a view's coordinates.
std::vector<PartDrawing::Line> lines_of_part(const Part& part, const CutFacesOfPart& cut,
                                             const LinesWanted& wanted);

}  // namespace displayfile
