#pragma once

#include "displayfile/looks/style.h"

namespace displayfile {

inline constexpr int kHeightColours = 64;

/// Colours that grow lighter evenly from a dark violet over blue-green to yellow, so that they tell
/// heights in grey and to the colour-blind too. `part` of the way, in [0,1].
Colour height_colour(double part);
/// The same in steps, as many as kHeightColours.
Colour height_colour_of_step(int step);

}  // namespace displayfile
