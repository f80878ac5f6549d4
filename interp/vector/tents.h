#pragma once

#include <span>
#include <vector>

#include "interp/vector/disjoint_fills.h"

namespace displayfile {

/// Triangles under the sides shared by two regions, in the paint of the earlier.
struct FigureTents {
  int segment;  ///< of the earlier
  FillPaint paint;
  LatticeLoops triangles;  ///< all in the same direction; where they overlap they are one
};

/// Replaces traps and a mask in formats without masks (interp/vector/seams.md): on either side of
/// each shared side a triangle that stays within the loops with the side, and is at most `reach`
/// units high. From the first region to the last; paths are at most Figure::kMostVertices long.
/// Each side is compared with its own loops: O(n^2) in the longest.
std::vector<FigureTents> tents_of(std::span<const FigureRegion> regions, double reach);

}  // namespace displayfile
