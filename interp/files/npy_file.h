#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "displayfile/files.h"
#include "interp/files/row_file.h"

namespace displayfile {

/// A two-dimensional array from a .npy file, shape (height, width), top row first.
struct NpyArray {
  int width = 0, height = 0;
  std::variant<std::vector<std::int32_t>, std::vector<double>> values;
};

/// Writes an array of shape (height, width) in NumPy's format 1.0 (numpy.lib.format: C order,
/// little endian, header padded to 64 bytes), of type int32 or float64. The file is written
/// completely or not at all. Throws Error if there are not width x height values, the size is not 1
/// to kLargestSide, or the file, which it names, cannot be written.
void write_npy(std::span<const std::int32_t> values, int width, int height, const Destination& to);
void write_npy(std::span<const double> values, int width, int height, const Destination& to);

/// The file that write_npy writes, for a picture's ids or depth, written row by row.
std::unique_ptr<RowFile> ids_row_file(const Destination& to, int width, int height);
std::unique_ptr<RowFile> depth_row_file(const Destination& to, int width, int height);

/// Reads files of write_npy, and arrays of type uint8 and int64 (as int32) and float32 (as
/// float64), in versions 1 to 3 of the format. Throws Error, naming the file and what was expected:
/// not a .npy file, truncated, another type, shape or order, a value beyond int32.
NpyArray read_npy(const std::filesystem::path& path);

}  // namespace displayfile
