#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

namespace displayfile {

/// A surface z = F(x, y) over a grid: points (x, y, z) with x at `x_points` even steps from x_min
/// to x_max, y likewise. In world coordinates, before the modelling transformation.
struct SurfaceGrid {
  double x_min, x_max;
  int x_points;
  double y_min, y_max;
  int y_points;
  std::span<const double> heights;  ///< z, x fastest; NaN where there is no surface

  std::size_t cells() const {
    return static_cast<std::size_t>(x_points - 1) * static_cast<std::size_t>(y_points - 1);
  }
  /// Cell (i, j) is there: the heights of its four corners are known.
  bool has_cell(int i, int j) const {
    assert(0 <= i && i + 1 < x_points && 0 <= j && j + 1 < y_points);
    const auto width = static_cast<std::size_t>(x_points);
    const std::size_t at = static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i);
    return !std::isnan(heights[at]) && !std::isnan(heights[at + 1]) &&
           !std::isnan(heights[at + width]) && !std::isnan(heights[at + width + 1]);
  }
  /// The ends of the range are met exactly.
  double x(int i) const { return at(x_min, x_max, x_points, i); }
  double y(int j) const { return at(y_min, y_max, y_points, j); }

 private:
  static double at(double low, double high, int points, int k) {
    const double part = static_cast<double>(k) / (points - 1);
    return k == points - 1 ? high : low + (high - low) * part;
  }
};

/// Throws Error unless there are 2 points or more each way, ranges are finite and rise, there is a
/// height for each point, and none of them is infinite.
void require_surface(const SurfaceGrid& grid);

/// Which curves of a surface are drawn as lines: those of x run along x, with y the same.
enum class SurfaceCurves { x, y, both };

/// The sides of a surface whose curves are drawn: the upper one is that which z grows toward.
enum class SurfaceSides { upper, lower, both };

/// Reads `x`, `y` or `both`; throws Error for anything else.
SurfaceCurves surface_curves(std::string_view text);
std::string_view name_of(SurfaceCurves curves);

/// Reads `upper`, `lower` or `both`; throws Error for anything else.
SurfaceSides surface_sides(std::string_view text);
std::string_view name_of(SurfaceSides sides);

}  // namespace displayfile
