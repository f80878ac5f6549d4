#pragma once

#include <cstdint>
#include <span>

#include "clip/point.h"
#include "interp/device/output_device.h"

namespace displayfile::python {

/// Draws the pieces of one polygon one after another where the picture stays what it was: of any
/// two pieces that overlap in the picture, the one that was drawn first is still drawn first.
/// Overlaps within a strip of 1e-9 of the picture's side do not count, except with lines. A polygon
/// all of whose pieces have come together, and do not overlap each other, is one piece again, with
/// the corners that it was given.
///
/// Points have x and y in [0,1]. Picks are the polygons' numbers; polygon k has sides[k] of the
/// points, which follow one another. Lines have higher picks, and stay as they are. The time grows
/// with the number of pieces and of those that lie near each.
void join_pieces(std::span<const std::uint32_t> sides, std::span<const Point3> points,
                 DrawnPieces& pieces);

}  // namespace displayfile::python
