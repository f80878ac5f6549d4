#pragma once

#include "hidden/exact/entered_polygon.h"

namespace displayfile {

/// Largest distance of a planar polygon's vertices from its support plane, as a fraction of the
/// largest entered coordinate times the length of the modelling matrix's longest column. Decimals
/// and a rotation leave polygons that planar.
inline constexpr double kFlatAsEntered = 0x1p-48;

/// True if a vertex is farther than that from the polygon's support plane as entered
/// (interp/truth/entered_truth.md), exactly; false for a polygon without a plane. `largest` is a
/// bound on the polygon's coordinates.
bool is_bent(const EnteredPolygon& polygon, double largest);

}  // namespace displayfile
