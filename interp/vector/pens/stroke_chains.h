#pragma once

#include <span>
#include <vector>

#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// A path drawn without lifting the pen: from point to point, and back to the first if it is closed
/// (at least three points then). One point is a dot.
struct PenPath {
  std::vector<SheetPoint> points;
  bool closed = false;
};
double length_of(const PenPath& path);  ///< in units, the closing side with it

/// Joins strokes that end at the same point into the fewest possible paths: a connected figure with
/// 2k > 0 points at which an odd number of strokes end takes k paths; one without such points takes
/// one, which is closed. Each stroke is drawn once. Points on straight runs, within kOnStroke, are
/// removed: collinear strokes become one.
std::vector<PenPath> stroke_chains(std::span<const Stroke> strokes);

}  // namespace displayfile
