#pragma once

#include <span>
#include <vector>

#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// What a pen draws without being lifted: from point to point, and back to the first if it is
/// closed (at least three points then). One point is a dot.
struct PenPath {
  std::vector<SheetPoint> points;
  bool closed = false;
};
double length_of(const PenPath& path);  ///< in units, the closing side with it

/// Joins strokes where they end at the same point into paths, as few as there can be: a connected
/// figure at 2k > 0 of whose points an odd number of strokes ends takes k paths, one without such
/// points takes one, which is closed. Each stroke is drawn once. Points on the way straight on,
/// within kOnStroke, are left out: strokes on one line become one.
std::vector<PenPath> stroke_chains(std::span<const Stroke> strokes);

}  // namespace displayfile
