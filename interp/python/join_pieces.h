#pragma once

#include <cstdint>
#include <span>

#include "clip/point.h"
#include "displayfile/drawn_pieces.h"

namespace displayfile::python {

/// Draws the pieces of one polygon one after another where the picture stays what it was: a piece
/// is drawn in the place of the polygon's next one if nothing that is drawn between them overlaps
/// it. A polygon all of whose pieces are in one place, and do not overlap each other, is one piece
/// again, with the corners that it was given. Picks are the polygons' numbers; polygon k has
/// sides[k] of the points, which follow one another.
void join_pieces(std::span<const std::uint32_t> sides, std::span<const Point3> points,
                 DrawnPieces& pieces);

}  // namespace displayfile::python
