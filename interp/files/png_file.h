#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "displayfile/files.h"
#include "interp/device/picture.h"
#include "interp/files/row_file.h"

namespace displayfile {

/// False in a build without libpng: the functions below then throw Error.
extern const bool kHasPng;

/// Alpha in a pixel file.
enum class Alpha { none, stored };

/// Writes the pixels as a PNG file, 8-bit RGB, or RGBA if one is not opaque. The bytes depend on
/// the pixels alone (no time or text is stored); the file appears whole or not at all. Throws
/// Error, naming the file, if it cannot be written or the picture's size is not 1 to kLargestSide.
void write_png(const Picture& picture, const Destination& to);

/// The file that write_png writes, byte for byte, for a picture of width x height that arrives row
/// by row: RGB, or RGBA.
std::unique_ptr<RowFile> png_row_file(const Destination& to, int width, int height);
std::unique_ptr<RowFile> png_alpha_row_file(const Destination& to, int width, int height);
/// The same, which states the picture's size if the density is known, in pixels per inch (pHYs, in
/// whole pixels per metre).
std::unique_ptr<RowFile> png_row_file_at(const Destination& to, int width, int height, Alpha alpha,
                                         std::optional<double> dpi);

/// Reads a PNG file of any colour type; 16-bit samples are reduced to 8 bits. Transparent pixels
/// are composited over white, or kept with Alpha::stored, where fully transparent ones are 0.
/// Throws Error, naming the file: not a PNG, truncated, damaged, or of a size beyond kLargestSide
/// or the file's length.
Picture read_png(const std::filesystem::path& path, Alpha alpha = Alpha::none);

}  // namespace displayfile
