#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "displayfile/graphics_system.h"
#include "hidden/precision.h"
#include "interp/picture.h"

namespace displayfile {

/// What draws raster pictures.
enum class RasterDevice { software, osmesa };

/// How a display file becomes a picture.
struct DrawOptions {
  int width = 512, height = 512;       ///< pixels; of a PDF, points
  std::optional<HiddenMethod> hidden;  ///< in place of what the application set
  RasterDevice device = RasterDevice::software;
  int threads = 1;
  Precision precision;
  std::filesystem::path ids;    ///< item buffer as int32 .npy, if not empty
  std::filesystem::path depth;  ///< depth of the fills seen as float64 .npy, if not empty
};

/// The method that draws the picture: that of the options, or else what the application set
/// with set_hidden_line_removal, set_hidden_method and set_z_buffer; never `automatic`.
HiddenMethod drawing_method(const GraphicsSystem& system, const DrawOptions& options);

/// Draws the visible segments into a picture in memory.
Picture draw(const GraphicsSystem& system, const DrawOptions& options = {});

/// Draws the visible segments into a file whose extension says its format. It appears whole
/// or not at all. Throws Error for an unknown extension, a size that a device cannot draw, or
/// a file that cannot be written.
void draw(const GraphicsSystem& system, const std::filesystem::path& file,
          const DrawOptions& options = {});

/// One line a format: the extension with its dot.
std::span<const std::string_view> picture_extensions();

}  // namespace displayfile
