#include "displayfile/graphics_system.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "clip/base/error.h"
#include "clip/base/words.h"
#include "clip/point.h"

namespace displayfile {

namespace {

constexpr Word<SurfaceCurves> kCurves[] = {
    {SurfaceCurves::x, "x"}, {SurfaceCurves::y, "y"}, {SurfaceCurves::both, "both"}};

constexpr Word<SurfaceSides> kSides[] = {
    {SurfaceSides::upper, "upper"}, {SurfaceSides::lower, "lower"}, {SurfaceSides::both, "both"}};

void require_range(char axis, double low, double high) {
  if (std::isfinite(low) && std::isfinite(high) && low < high) return;
  throw Error(fmt::format("surface from {0} {1} to {2}: expected finite numbers, {0}-min < {0}-max",
                          axis, low, high));
}

}  // namespace

void require_surface(const SurfaceGrid& grid) {
  if (grid.x_points < 2 || grid.y_points < 2) {
    throw Error(fmt::format("surface of {} x {} points: expected 2 or more each way", grid.x_points,
                            grid.y_points));
  }
  require_range('x', grid.x_min, grid.x_max);
  require_range('y', grid.y_min, grid.y_max);
  const auto width = static_cast<std::size_t>(grid.x_points);
  const std::size_t points = width * static_cast<std::size_t>(grid.y_points);
  if (grid.heights.size() != points) {
    throw Error(fmt::format("surface of {} x {} points with {} heights: expected {}", grid.x_points,
                            grid.y_points, grid.heights.size(), points));
  }
  for (std::size_t k = 0; k < points; ++k) {
    if (!(std::abs(grid.heights[k]) > kCoordinateLimit)) continue;
    throw Error(fmt::format(
        "height {} of point {} {} of the surface: expected finite numbers of magnitude at most {}, "
        "or nan for a hole",
        grid.heights[k], k % width + 1, k / width + 1, kCoordinateLimit));
  }
}

SurfaceCurves surface_curves(std::string_view text) {
  return value_of(kCurves, text, "curves of a surface are");
}
std::string_view name_of(SurfaceCurves curves) { return word_of(kCurves, curves); }

SurfaceSides surface_sides(std::string_view text) {
  return value_of(kSides, text, "sides of a surface are");
}
std::string_view name_of(SurfaceSides sides) { return word_of(kSides, sides); }

}  // namespace displayfile
