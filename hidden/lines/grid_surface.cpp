#include "hidden/lines/grid_surface.h"

#include <fmt/format.h>

#include <algorithm>

#include "clip/base/error.h"

namespace displayfile {

GridSurface::GridSurface(const Primitives& items) {
  const std::string wrong = take(items);
  if (wrong.empty()) return;
  throw Error(fmt::format(
      "hidden-line method 'perimeter' draws one surface, whole and of solid cells; {}: expected "
      "another method, such as franklin",
      wrong));
}

std::optional<GridSurface> GridSurface::of(const Primitives& items) {
  GridSurface surface;
  if (items.surfaces.size() != 1 || !surface.take(items).empty()) return std::nullopt;
  return surface;
}

std::string GridSurface::take(const Primitives& items) {
  const auto is_polygon = [](const Primitives::Item& item) {
    return item.kind != Primitives::Kind::line;
  };
  if (items.surfaces.empty()) return "there is none that is entered at once (surface-3)";
  if (items.surfaces.size() > 1) return fmt::format("there are {}", items.surfaces.size());
  mark_ = items.surfaces[0];
  const auto first = std::ranges::find_if(items.items, is_polygon);
  first_item_ = static_cast<std::uint32_t>(first - items.items.begin());
  const auto polygons = static_cast<std::size_t>(std::ranges::count_if(items.items, is_polygon));
  if (polygons > std::size_t{2} * columns() * rows()) return "there are polygons beside it";
  points_.resize(points());
  for (std::uint32_t j = 0; j < rows(); ++j) {
    for (std::uint32_t i = 0; i < columns(); ++i) {
      if (take_cell(items, i, j)) continue;
      return fmt::format("its cell {} {} is missing, clipped, hollow, turned away or of no length",
                         i + 1, j + 1);
    }
  }
  return {};
}

bool GridSurface::is_solid_triangle(const Primitives& items, std::uint32_t number) {
  if (number >= items.items.size()) return false;
  const Primitives::Item& item = items.items[number];
  return item.kind == Primitives::Kind::solid && item.sides == 3;
}

/// Stores the points that no earlier cell has, and compares the cell with all of its points: cells
/// share points bit for bit, while a clipped cell has others.
bool GridSurface::take_cell(const Primitives& items, std::uint32_t i, std::uint32_t j) {
  const std::uint32_t item = first_triangle(i, j);
  if (!is_solid_triangle(items, item) || !is_solid_triangle(items, item + 1)) return false;
  Point3 &a = points_[number(i, j)], &b = points_[number(i + 1, j)],
         &c = points_[number(i + 1, j + 1)], &d = points_[number(i, j + 1)];
  const auto corner = [&](std::uint32_t triangle, std::uint32_t k) -> const Point3& {
    return items.points[items.point(items.items[triangle].first + k)];
  };
  if (i == 0 && j == 0) a = corner(item, 0);
  if (j == 0) b = corner(item, 1);
  if (i == 0) d = corner(item + 1, 2);
  c = corner(item, 2);
  return corner(item, 0) == a && corner(item, 1) == b && corner(item + 1, 0) == a &&
         corner(item + 1, 1) == c && corner(item + 1, 2) == d && a != b && b != c && c != a &&
         c != d && d != a;
}

std::uint32_t GridSurface::side(std::uint32_t item, std::uint32_t corner) const {
  if (!has(item)) return kNone;
  const std::uint32_t triangle = item - first_item_, cell = triangle / 2;
  const std::uint32_t i = cell % columns(), j = cell / columns();
  if (triangle % 2 == 0) {  // corner 0 ends the side from corner 2, and so on
    return corner == 0 ? diagonal(i, j) : corner == 1 ? side_along_x(i, j) : side_along_y(i + 1, j);
  }
  return corner == 0 ? side_along_y(i, j) : corner == 1 ? diagonal(i, j) : side_along_x(i, j + 1);
}

}  // namespace displayfile
