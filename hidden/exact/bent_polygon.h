#pragma once

#include "hidden/exact/entered_polygon.h"

namespace displayfile {

/// Within how much of the largest coordinate that was entered, times the length of the longest
/// column of the modelling matrix, a polygon's vertices are from its support plane if it is flat.
/// Decimals and a turn leave polygons that flat.
inline constexpr double kFlatAsEntered = 0x1p-48;

/// True if some vertex is farther from the polygon's support plane as entered
/// (interp/truth/entered_truth.md) than that, exactly; false for a polygon without a plane.
/// `largest` is a magnitude that no coordinate of the polygon exceeds.
bool is_bent(const EnteredPolygon& polygon, double largest);

}  // namespace displayfile
