#pragma once

#include <span>
#include <vector>

#include "interp/vector/disjoint_fills.h"

namespace displayfile {

/// Triangles under the sides that two regions share, in the paint of the earlier.
struct FigureTents {
  FillPaint paint;
  LatticeLoops triangles;  ///< all in the same direction; where they overlap they are one
};

/// What takes the place of traps and a mask where a format has no masks (interp/vector/seams.md):
/// on either side of each shared side a triangle that stays within the loops that have the side,
/// and is no higher than `reach` units. From the last region to the first; paths are no longer than
/// Figure::kMostVertices. Each side looks at its own loops: O(n^2) in the longest.
std::vector<FigureTents> tents_of(std::span<const FigureRegion> regions, double reach);

}  // namespace displayfile
