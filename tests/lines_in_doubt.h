#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <set>
#include <span>

#include "displayfile/segments/display_file.h"

namespace displayfile::test {

/// The sides of polygons in the projection, each once.
struct SidesInPicture {
  std::set<std::array<double, 4>>
      all;  // x and y of the end that comes first by x, then y; the other's

  void fill(const FillStyle& /*style*/) {}
  void line_style(const LineStyle& /*style*/) {}
  void pick(std::int32_t /*id*/) {}
  void move(const Point3& /*to*/) {}
  void line(const Point3& /*to*/) {}
  void polygon(std::span<const Point3> corners, std::span<const std::int32_t> /*sides*/) {
    const Point3* from = &corners.back();
    for (const Point3& to : corners) {
      const auto [first, last] =
          std::minmax({std::array{from->x, from->y}, std::array{to.x, to.y}});
      if (first != last) all.insert({first[0], first[1], last[0], last[1]});
      from = &to;
    }
  }
};

/// The length of sides that rounding leaves undecided: where two cross at a small angle, a digit of
/// a coordinate moves the crossing by itself over the angle (hidden/lines/perimeter.md). Another
/// side is drawn there.
inline double length_in_doubt(const DisplayFile& file) {
  SidesInPicture sides;
  for (const Segment& segment : file.segments()) segment.walk_entered(sides);
  const auto cross = [](const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; };
  constexpr double kDigit = 0x1p-50, kSmallAngle = 1e-3;
  double doubt = 0.0;
  for (const auto& side : sides.all) {
    const Point2 from(side[0], side[1]), to(side[2], side[3]);
    const double length = glm::distance(from, to);
    const Point2 way = (to - from) / length;
    for (const auto& other : sides.all) {
      const Point2 first = Point2(other[0], other[1]) - from,
                   last = Point2(other[2], other[3]) - from;
      const double angle = std::abs(cross(way, last - first)) / glm::distance(first, last);
      const auto [low, high] = std::minmax({glm::dot(way, first), glm::dot(way, last)});
      const double beside = std::min(high, length) - std::max(low, 0.0);
      const double at_first = cross(way, first), at_last = cross(way, last);
      const bool apart =
          at_first * at_last > 0.0 && std::min(std::abs(at_first), std::abs(at_last)) > kDigit;
      if (other == side || angle > kSmallAngle || beside <= kDigit || apart) continue;
      doubt += std::min(beside, kDigit / angle);
    }
  }
  return doubt;
}

}  // namespace displayfile::test
