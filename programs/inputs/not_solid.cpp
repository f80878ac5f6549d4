#include "programs/inputs/not_solid.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace displayfile {

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string NotSolid::words() const {
  std::vector<std::string> parts;
  if (lines > 0) parts.push_back(counted(lines, "line", "lines"));
  if (hollow > 0) parts.push_back(counted(hollow, "hollow polygon", "hollow polygons"));
  if (texts > 0) parts.push_back(counted(texts, "text", "texts"));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace displayfile
