#pragma once

#include <vector>

#include "interp/vector/pens/stroke.h"

namespace displayfile {

/// The strokes of one pen without duplicates: parts that lie on a longer stroke are removed, and
/// the rest of a cut stroke begins at the other's end. Strokes lie on each other where they run
/// within kOnStroke of each other. So the original drawing is within kOnStroke of the result, and
/// for strokes on a line with only whole-unit points (vertical, horizontal, or with unrounded
/// points) the result is exactly their union. The order is a function of the strokes alone.
std::vector<Stroke> unique_strokes(std::vector<Stroke> strokes);

}  // namespace displayfile
