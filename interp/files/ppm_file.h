#pragma once

#include <filesystem>
#include <memory>

#include "displayfile/files.h"
#include "interp/device/picture.h"
#include "interp/files/row_file.h"

namespace displayfile {

/// Writes the pixels as a PPM file (P6, 8 bits); it appears whole or not at all. Throws Error,
/// naming the file, if it cannot be written or the picture's size is not 1 to kLargestSide.
void write_ppm(const Picture& picture, const Destination& to);

/// The file that write_ppm writes, for a picture of width x height that arrives row by row.
std::unique_ptr<RowFile> ppm_row_file(const Destination& to, int width, int height);

/// Reads a PPM file (P6, largest value 255; the first picture of several). Throws Error, naming
/// the file and what was expected: not a PPM, truncated, a size of 0 or beyond kLargestSide.
Picture read_ppm(const std::filesystem::path& path);

}  // namespace displayfile
