#pragma once

#include <span>
#include <string_view>

#include "displayfile/display_file.h"
#include "interp/picture.h"

namespace displayfile {

/// What a depth is stored as. The integers spread the depths 0 to 1 evenly over all their
/// values, as frame buffers do; what is nearer or farther is stored as 1 or 0.
enum class DepthFormat { float_32, float_64, integer_16, integer_24, integer_32 };

/// One line a format.
struct DepthFormatEntry {
  DepthFormat format;
  std::string_view name;
};
std::span<const DepthFormatEntry> depth_formats();

/// The z-buffer as textbooks give it, to be read, and to measure what it gets wrong: x and z are
/// stepped along edges and spans by adding, and depths are compared as they are stored.
/// SoftwareRenderer is the one that draws what is true.
///
/// Draws the fills of the visible segments on white; lines are left out. Of equal stored depths
/// the polygon entered later is seen. Of the request the size, ids and depth (as stored, in z)
/// count; there are no threads. Throws Error for a size outside of 1 to kLargestSide.
Picture draw_with_plain_z_buffer(const DisplayFile& display_file, const RasterRequest& request,
                                 DepthFormat format);

}  // namespace displayfile
