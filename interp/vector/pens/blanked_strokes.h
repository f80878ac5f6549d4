#pragma once

#include <span>
#include <vector>

#include "clip/point.h"
#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// The parts of strokes outside of a convex polygon, which hides earlier drawing. Its points are in
/// the unit of strokes, in either direction. Strokes along its boundary are kept; where a stroke is
/// cut, its new end is rounded to integer units, and a part shorter than that is omitted.
std::vector<Stroke> strokes_outside(std::span<const Stroke> strokes,
                                    std::span<const Point2> polygon);

}  // namespace displayfile
