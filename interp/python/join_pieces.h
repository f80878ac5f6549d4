#pragma once

#include <cstdint>
#include <span>

#include "clip/point.h"
#include "interp/device/output_device.h"

namespace displayfile::python {

/// Makes the pieces of one polygon consecutive where the picture does not change: of any two pieces
/// that overlap in the picture, the one drawn first is still drawn first. Overlaps within a strip
/// of 1e-9 of the picture's side are ignored, except with lines. A polygon whose pieces have all
/// become consecutive, and do not overlap each other, is rejoined to one piece with its original
/// corners.
///
/// Points have x and y in [0,1]. Picks are the polygons' numbers; polygon k has sides[k] of the
/// points, which follow one another. Lines have higher picks, and stay as they are. The time grows
/// with the number of pieces and of those that lie near each.
void join_pieces(std::span<const std::uint32_t> sides, std::span<const Point3> points,
                 DrawnPieces& pieces);

}  // namespace displayfile::python
