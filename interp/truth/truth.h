#pragma once

#include "clip/base/work_progress.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"

namespace displayfile {

class DepthTies;

/// What is seen at each pixel centre, by the definition of truth alone: whole numbers of any
/// length, no tolerance, and nothing shared with the methods that it judges. interp/truth/truth.md
/// explains.
///
/// The item buffer holds, of the visible segments' solid polygons after the image transformation,
/// the pick identifier of the nearest that covers the centre (of equally near ones the one entered
/// later), -1 where none does. If depth is asked for, it is that of the polygon seen, rounded once
/// to the nearest double, and minus infinity where none is. No colours: `pixels` stays empty.
/// `progress` is told of polygons. `ties`, if given, must be empty and gets the
/// ties (interp/truth/depth_ties.h).
///
/// Coordinates may be any finite doubles. Throws Error for a picture size outside of 1 to
/// kLargestSide, and for a coordinate of a solid polygon that is not finite.
Picture truth(const DisplayFile& display_file, int width, int height, bool depth,
              const WorkProgress& progress = {}, DepthTies* ties = nullptr);

}  // namespace displayfile
