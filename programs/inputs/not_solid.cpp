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
  const auto add = [&](std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) parts.push_back(counted(count, one, many));
  };
  add(lines, "line", "lines");
  add(hollow, "hollow polygon", "hollow polygons");
  add(without_area, "polygon without area", "polygons without area");
  add(texts, "text", "texts");
  add(dimensions, "dimension", "dimensions");
  add(leaders, "leader", "leaders");
  add(balloons, "balloon", "balloons");
  add(titles, "title", "titles");
  add(lists, "parts list", "parts lists");
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace displayfile
