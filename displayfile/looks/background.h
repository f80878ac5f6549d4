#pragma once

#include "clip/surfaces.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// Throws Error for the colour rule if there is no background, whose colour fills have in vectors
/// and in dumps.
void require_colour_of_fills(HiddenMethod method, const Background& background);

}  // namespace displayfile
