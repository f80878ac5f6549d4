#pragma once

#include "clip/base/work_progress.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"

namespace displayfile {

class DepthTies;

/// The fill visible at each pixel centre, by the definition of truth alone: in integers of any
/// length, without tolerance, and sharing no code with the methods that it checks.
/// interp/truth/truth.md has the details.
///
/// The item buffer has, for the visible segments' solid polygons after the image transformation,
/// the pick identifier of the nearest one that covers the centre (of equally near ones the one
/// entered later), -1 for none. The depth, if requested, is that of the visible polygon, rounded
/// once to the nearest double, and minus infinity for none. No colours: `pixels` is empty.
/// `progress` counts polygons. `ties`, if not null, must be empty and gets the ties
/// (interp/truth/depth_ties.h).
///
/// Coordinates may be any finite doubles. Throws Error for a picture size outside of 1 to
/// kLargestSide, and for a coordinate of a solid polygon that is not finite.
Picture truth(const DisplayFile& display_file, int width, int height, bool depth,
              const WorkProgress& progress = {}, DepthTies* ties = nullptr);

}  // namespace displayfile
