#pragma once

#include "clip/surfaces.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// Throws Error for the colour rule without a background, whose colour its fills have in vectors
/// and dumps.
void require_colour_of_fills(HiddenMethod method, const Background& background);

}  // namespace displayfile
