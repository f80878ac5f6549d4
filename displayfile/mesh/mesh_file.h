#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// A mesh file in a format with a built-in reader, its whole content in memory.
struct MeshFile {
  std::string path;
  std::string data;
  bool with_normals = false;  ///< read vertex normals, if the file has them
};

/// Built-in readers. Each throws Error with file, line and column (text) or file and element number
/// (binary), and what was expected. Announced counts are limited by the bytes that follow.
Mesh read_obj(const MeshFile& file);
Mesh read_off(const MeshFile& file);
Mesh read_ply(const MeshFile& file);
Mesh read_stl(const MeshFile& file);

/// The extensions of built-in readers, with dots.
std::vector<std::string> extensions_read_here();

/// The extensions that read_mesh supports, with their dots, in alphabetical order. Loads the import
/// library.
std::vector<std::string> mesh_extensions();

/// The number stored in the first bytes, which must exist.
template <class Number>
Number binary_value(std::string_view bytes, std::endian order) {
  std::array<char, sizeof(Number)> raw;
  std::copy_n(bytes.begin(), raw.size(), raw.begin());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

/// Red, green, blue and opacity as in a file: up to 1 or up to 255.
using Rgba = glm::dvec4;

/// The default opacity, valid for both scales.
inline constexpr double kOpaque = 255.0;

/// Components scaled to [0,1]; minus zero becomes zero.
template <class Parts>
Parts brought_into_range(const Parts& parts) {
  return glm::clamp(parts, 0.0, 1.0) + 0.0;
}

}  // namespace displayfile
