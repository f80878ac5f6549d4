#pragma once

#include <vector>

#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// The strokes of one pen without what it would draw twice: what lies on a longer stroke, all of it
/// or a part, is left out, and the rest of a stroke that is cut begins at the other's end. Strokes
/// lie on each other where they run beside each other within kOnStroke. So all that was drawn is
/// within kOnStroke of what is left, and where strokes lie on a line of which every point is whole
/// units (an upright one, a level one, any whose points were not rounded), what is left is exactly
/// their union. The order is a function of the strokes alone.
std::vector<Stroke> unique_strokes(std::vector<Stroke> strokes);

}  // namespace displayfile
