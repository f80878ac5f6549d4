#pragma once

#include "clip/view.h"

namespace displayfile {

/// Width over height.
double shape_of(const Rectangle& rectangle);

/// Width over height of a viewport in a picture with this aspect ratio.
double shape_in_picture(const Rectangle& viewport, double aspect);

/// True if two aspect ratios differ by more than rounding.
bool shapes_differ(double a, double b);

/// The smallest window with this aspect ratio and the same middle that contains the given one,
/// which is returned unchanged if it has the aspect ratio except for rounding.
Rectangle widened(const Rectangle& window, double shape);

}  // namespace displayfile
