#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace displayfile {

/// The contents of an input that are not solid fills, for commands that take no others.
struct NotSolid {
  std::size_t lines = 0, hollow = 0, texts = 0;
  std::size_t leaders = 0, balloons = 0, dimensions = 0, titles = 0, lists = 0;
  std::size_t without_area = 0;  ///< polygons of which no triangle is left

  /// "2 lines, 1 hollow polygon, 1 text"; empty if there are none.
  std::string words() const;
};

/// "1 line", or "2 lines".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

}  // namespace displayfile
