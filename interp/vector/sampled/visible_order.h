#pragma once

#include "displayfile/display_file.h"
#include "interp/vector/vector_device.h"

namespace displayfile {

/// Draws the visible segments on a vector device so that it shows what a z-buffer of width x
/// height pixels (those of the device) shows: the nearest fill, of equally near ones the one
/// entered later, and lines and edges where no fill is nearer.
///
/// The z-buffer tells, at every pixel centre, which polygon is seen and which it hides; fills are
/// drawn in an order in which the hidden ones come first (interp/vector/sampled/drawing_order.h),
/// so that at every pixel centre the one drawn last is the one seen. Polygons that overlap in a
/// cycle are drawn again within the pixels where they are seen. Polygons of which nothing is seen
/// are left out. Then the seen parts of lines and edges are drawn
/// (interp/vector/sampled/visible_lines.h). A segment may begin and end several times.
///
/// All that is drawn is read from the one scene (displayfile/viewed_scene.h). Memory beside it: the
/// z-buffer's fills, some depths a fill, and what a few million pixels show; larger pictures are
/// worked through in bands of rows. This is the room's only door. Throws Error for a size outside
/// of 1 to kLargestSide.
void draw_in_visible_order(const DisplayFile& display_file, int width, int height,
                           VectorDevice& device);

}  // namespace displayfile
