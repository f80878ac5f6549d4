#pragma once

#include <algorithm>
#include <cstdint>

#include "clip/transformation.h"
#include "displayfile/instructions.h"
#include "hidden/exact/precision.h"
#include "hidden/hidden_method.h"

namespace displayfile {

/// What a sort of hidden surfaces cost.
struct SortCounts {
  std::uint64_t pieces = 0;  ///< polygons and lines in the order, cut ones once a piece
  std::uint64_t cuts = 0;    ///< one piece in two
  std::uint64_t comparisons = 0;
  std::uint32_t depth = 0;  ///< of the deepest tree; 0 where there is none

  SortCounts& operator+=(const SortCounts& other) {
    pieces += other.pieces;
    cuts += other.cuts;
    comparisons += other.comparisons;
    depth = std::max(depth, other.depth);
    return *this;
  }
};

/// The instructions of one segment, or of several with a segment instruction wherever the
/// segment changes, back to front: what the hidden-surface check makes.
struct SortedInstructions {
  Instructions instructions;
  ImageTransformation image;  ///< that the points of a single segment went through before
  HiddenMethod method;        ///< that sorted them
  Precision precision;
  SortCounts counts;
  /// How far a boundary may lie from where the polygons as entered have it, beyond the rounding of
  /// a cut's own coordinates: where the cuts were made before viewing. Device coordinates.
  double boundary_error = 0.0;
};

}  // namespace displayfile
