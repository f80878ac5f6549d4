#include "displayfile/solids/hatched_loops.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace displayfile {

namespace {

/// Where a side crosses a hatching line.
struct Crossing {
  std::int64_t line;
  double along;
  int winding;  ///< increase of the loops' winding number along the line

  /// At equal positions, beginnings come first: the line continues.
  bool operator<(const Crossing& other) const {
    return std::tuple(line, along, -winding) < std::tuple(other.line, other.along, -other.winding);
  }
};

}  // namespace

std::vector<std::pair<Point2, Point2>> hatched_loops(const std::vector<std::vector<Point2>>& loops,
                                                     WithinLoops within, double spacing,
                                                     const Point2& direction) {
  std::vector<Crossing> crossings;
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
        const double x = x0 + (x1 - x0) * (static_cast<double>(k) - y0) / (y1 - y0);
        crossings.push_back({k, x, y0 > y1 ? 1 : -1});
      }
      from = to;
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<std::pair<Point2, Point2>> lines;
  const auto point = [&](std::int64_t k, double x) {
    const double y = static_cast<double>(k) * spacing;
    return Point2(x * direction.x - y * direction.y, x * direction.y + y * direction.x);
  };
  int depth = 0;  // 0 before each line begins
  double begin = 0.0;
  for (const Crossing& crossing : crossings) {
    if (depth == 0) begin = crossing.along;
    depth = within == WithinLoops::odd ? 1 - depth : depth + crossing.winding;
    if (depth == 0) {
      lines.emplace_back(point(crossing.line, begin), point(crossing.line, crossing.along));
    }
  }
  return lines;
}

}  // namespace displayfile
