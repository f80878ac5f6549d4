#pragma once

#include "clip/view.h"

namespace displayfile {

/// Width over height.
double shape_of(const Rectangle& rectangle);

/// The width over the height of a viewport in a picture of this aspect ratio, its width over its
/// height.
double shape_in_picture(const Rectangle& viewport, double aspect);

/// True if two shapes differ by more than rounding.
bool shapes_differ(double a, double b);

/// The smallest window of this shape that has the same middle and holds all of the one given, which
/// is returned to the bit if it has that shape but for rounding.
Rectangle widened(const Rectangle& window, double shape);

}  // namespace displayfile
