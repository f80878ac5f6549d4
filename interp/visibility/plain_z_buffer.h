#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

/// Storage formats of depths. Integers divide the depths 0 to 1 evenly, as frame buffers do; nearer
/// and farther depths are stored as 1 or 0.
enum class DepthFormat { float_32, float_64, integer_16, integer_24, integer_32 };

/// A row of the table of formats.
struct DepthFormatEntry {
  DepthFormat format;
  std::string_view name;
};
std::span<const DepthFormatEntry> depth_formats();

/// The z-buffer in its textbook form, for reading, and for measuring its errors: x and z are
/// incremented along edges and spans, and depths are compared as stored. Of equal stored depths the
/// polygon entered later is visible. The other methods draw the true picture.
///
/// As an image-space method (`--hidden plain-z-buffer=FORMAT`) it decides which fill is visible at
/// each pixel. Edge-on polygons are omitted, and lines, shades, shadows and the depths of --depth
/// are those of the visible fills, as with every method. It stores a depth and a fill per pixel,
/// computed when it prepares for the scene, in one thread, and has no ROUNDOFF.
std::unique_ptr<ImageSpaceMethod> make_plain_z_buffer(DepthFormat format);

/// Draws by the plain z-buffer alone, for measurement: the fills of the visible segments on the
/// background, without lines. Only the size, ids and depth (as stored, in z) of the request are
/// used; there are no threads. Throws Error for a size outside of 1 to kLargestSide.
Picture draw_with_plain_z_buffer(const DisplayFile& display_file, const RasterRequest& request,
                                 DepthFormat format);

}  // namespace displayfile
