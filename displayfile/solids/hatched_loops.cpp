#include "displayfile/solids/hatched_loops.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace displayfile {

std::vector<std::pair<Point2, Point2>> hatched_loops(const std::vector<std::vector<Point2>>& loops,
                                                     double spacing, const Point2& direction) {
  // A crossing of a side with a hatching line: the line's number, and the place along it.
  std::vector<std::pair<std::int64_t, double>> crossings;
  const auto along = [&](const Point2& p) { return p.x * direction.x + p.y * direction.y; };
  const auto across = [&](const Point2& p) {
    return (p.y * direction.x - p.x * direction.y) / spacing;
  };
  for (const auto& loop : loops) {
    Point2 from = loop.back();
    for (const Point2& to : loop) {
      const double y0 = across(from), y1 = across(to), x0 = along(from), x1 = along(to);
      const auto [low, high] = std::minmax(y0, y1);
      for (auto k = static_cast<std::int64_t>(std::floor(low)) + 1; static_cast<double>(k) <= high;
           ++k) {
        crossings.emplace_back(k, x0 + (x1 - x0) * (static_cast<double>(k) - y0) / (y1 - y0));
      }
      from = to;
    }
  }
  std::ranges::sort(crossings);
  std::vector<std::pair<Point2, Point2>> lines;
  const auto point = [&](std::int64_t k, double x) {
    const double y = static_cast<double>(k) * spacing;
    return Point2(x * direction.x - y * direction.y, x * direction.y + y * direction.x);
  };
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const auto [k, begin] = crossings[i];
    lines.emplace_back(point(k, begin), point(k, crossings[i + 1].second));
  }
  return lines;
}

}  // namespace displayfile
