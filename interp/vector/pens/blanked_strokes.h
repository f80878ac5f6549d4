#pragma once

#include <span>
#include <vector>

#include "clip/point.h"
#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// The parts of strokes that are not within a convex polygon, which hides what was drawn before it.
/// Its points are in the unit of strokes, in either direction. Strokes along its boundary stay;
/// where a stroke is cut its new end is rounded to whole units, and a part shorter than that is
/// left out.
std::vector<Stroke> strokes_outside(std::span<const Stroke> strokes,
                                    std::span<const Point2> polygon);

}  // namespace displayfile
