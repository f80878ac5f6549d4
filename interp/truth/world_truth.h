#pragma once

#include "displayfile/segments/retained_scene.h"
#include "interp/truth/truth.h"

namespace displayfile {

/// The fill visible at each pixel centre without the rounding of viewing: the definition of truth
/// applied to the polygons in world coordinates, transformed by the view's matrix, the view volume,
/// the viewport and the image transformation in integers of any length; the doubles of the matrices
/// are taken as exact. It shares only the input with the methods. interp/truth/world_truth.md has
/// the details. Where it differs from truth(display_file), the rounding of viewing decides.
///
/// `retained` has all primitives of the display file. Item buffer, depth and errors as in truth().
Picture world_truth(const RetainedScene& retained, const DisplayFile& display_file, int width,
                    int height, bool depth, const WorkProgress& progress = {});

/// Pixels that differ between two item buffers of one size.
std::size_t different_pixels(const Picture& a, const Picture& b);

}  // namespace displayfile
