#include "programs/surface/contours.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace displayfile {

namespace {

/// The point at a height on the side from a to b, of which one end is below the height and the
/// other not: the same for both directions of the side.
Point3 on_side(Point3 a, Point3 b, double height, double drawn_at) {
  if (a.z > b.z) std::swap(a, b);
  const double part = (height - a.z) / (b.z - a.z);
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), drawn_at};
}

}  // namespace

std::vector<std::array<Point3, 2>> contour_lines(const SurfaceGrid& grid, double low, double high,
                                                 int levels, double drawn_at) {
  std::vector<std::array<Point3, 2>> lines;
  const auto point = [&](int i, int j) {
    const auto k = static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.x_points) +
                   static_cast<std::size_t>(i);
    return Point3(grid.x(i), grid.y(j), grid.heights[k]);
  };
  const auto add_triangle = [&](const std::array<Point3, 3>& corners) {
    for (int level = 1; level <= levels; ++level) {
      const double height = low + (high - low) * (static_cast<double>(level) / (levels + 1));
      std::array<Point3, 2> ends;
      std::size_t found = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3 &a = corners[k], &b = corners[(k + 1) % 3];
        if ((a.z < height) == (b.z < height)) continue;
        ends[found++] = on_side(a, b, height, drawn_at);
      }
      if (found == 2 && ends[0] != ends[1]) lines.push_back(ends);
    }
  };
  for (int j = 0; j + 1 < grid.y_points; ++j) {
    for (int i = 0; i + 1 < grid.x_points; ++i) {
      const Point3 a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1),
                   d = point(i, j + 1);
      if (std::isnan(a.z + b.z + c.z + d.z)) continue;
      add_triangle({a, b, c});
      add_triangle({a, c, d});
    }
  }
  return lines;
}

}  // namespace displayfile
