// libFuzzer target: of a surface over a small grid, seen from anywhere, the perimeter method finds
// what the truth of lines says is seen, or refuses it with an Error.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "interp/truth/judged_lines.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/fuzz_input.h"

namespace {

using namespace displayfile;

/// Heights and the eye are near grids, so that curves lie in line with it.
void enter_surface(fuzz::FuzzInput input, GraphicsSystem& system) {
  const int grid = 1 + input.below(8), nx = 2 + input.below(6), ny = 2 + input.below(6);
  const Point3 eye = input.point_near_grid(grid) * 8.0;
  system.set_view_up({0.0, 0.0, 1.0});
  system.set_view_plane_normal(-eye);
  if (input.below(2) == 0) {
    system.set_parallel(-eye);
  } else {
    system.set_perspective(eye);
  }
  system.set_window(-30, 30, -30, 30);
  std::vector<double> heights;
  for (int k = 0; k < nx * ny; ++k) heights.push_back(input.near_grid(grid));
  system.open_segment(1);
  system.surface_3({-1.0, 1.0, nx, -1.0, 1.0, ny, heights});
  system.close_segment();
}

/// The sides of polygons in the projection, each once.
struct Sides {
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
/// a coordinate moves the crossing by itself over the angle (hidden/lines/perimeter.md).
double length_in_doubt(const DisplayFile& file) {
  Sides sides;
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  GraphicsSystem system;
  JudgedLines judged;
  try {
    enter_surface(fuzz::FuzzInput({data, size}), system);
    judged = judged_lines(system.display_file(), {.method = HiddenMethod::perimeter});
  } catch (const Error&) {
    return 0;  // no direction to look in, or some of it behind the eye
  }
  const double wrong = judged.errors.missing + judged.errors.extra;
  const double crumbs = kLineCrumb * static_cast<double>(judged.lines);
  if (wrong > crumbs && wrong > crumbs + length_in_doubt(system.display_file())) {
    fuzz::failed("missing " + std::to_string(judged.errors.missing) + ", extra " +
                 std::to_string(judged.errors.extra));
  }
  return 0;
}
