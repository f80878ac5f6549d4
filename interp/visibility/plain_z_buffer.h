#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"
#include "interp/visibility/image_space.h"

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
/// stepped along edges and spans by adding, and depths are compared as they are stored. Of equal
/// stored depths the polygon entered later is seen. The other methods draw what is true.
///
/// As a method of a picture (`--hidden plain-z-buffer=FORMAT`) it says which fill is seen where.
/// Edge-on polygons are left out, and lines, shades, shadows and the depths of --depth are those of
/// the fills seen, as with every method. It holds a depth and a fill for every pixel, finds them
/// when it takes up the scene, in one thread, and knows no ROUNDOFF.
std::unique_ptr<ImageSpaceMethod> make_plain_z_buffer(DepthFormat format);

/// Draws by the plain z-buffer alone, to be measured: the fills of the visible segments on the
/// background; lines are left out. Only the size, ids and depth (as stored, in z) of the request
/// count; there are no threads. Throws Error for a size outside of 1 to kLargestSide.
Picture draw_with_plain_z_buffer(const DisplayFile& display_file, const RasterRequest& request,
                                 DepthFormat format);

}  // namespace displayfile
