#pragma once

#include "displayfile/segments/retained_scene.h"
#include "interp/truth/truth.h"

namespace displayfile {

/// What is seen at each pixel centre if viewing does not round: the definition of truth applied to
/// the polygons in world coordinates, which go through the view's matrix, the view volume, the
/// viewport and the image transformation as whole numbers of any length; the doubles of the
/// matrices are taken as they are. Nothing is shared with the methods but the input.
/// interp/truth/world_truth.md explains. Where it differs from truth(display_file), the rounding of
/// viewing decides.
///
/// `retained` is what was drawn into the display file, all of it. Item buffer, depth and errors as
/// in truth().
Picture world_truth(const RetainedScene& retained, const DisplayFile& display_file, int width,
                    int height, bool depth, const WorkProgress& progress = {});

/// Pixels that differ between two item buffers of one size.
std::size_t different_pixels(const Picture& a, const Picture& b);

}  // namespace displayfile
