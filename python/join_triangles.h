#pragma once

#include <cstdint>
#include <span>

#include "clip/point.h"
#include "displayfile/drawn_pieces.h"

namespace displayfile::python {

/// Makes one piece again of each polygon that was sorted as triangles for not being flat, in the
/// place of the last of them, if its triangles do not overlap each other and nothing that is drawn
/// between them overlaps the earlier ones: the picture stays what it was. Picks are the polygons'
/// numbers; polygon k has sides[k] of the points, which follow one another.
void join_triangles(std::span<const std::uint32_t> sides, std::span<const Point3> points,
                    DrawnPieces& pieces);

}  // namespace displayfile::python
