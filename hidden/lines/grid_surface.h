#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hidden/primitives.h"
#include "hidden/surface_mark.h"

namespace displayfile {

/// The one surface among some items: its cells of two triangles each, row by row, as surface_3
/// enters them.
class GridSurface {
 public:
  /// Throws Error unless the items' polygons are the solid triangles of one surface, none clipped
  /// or omitted; the message names an alternative method.
  explicit GridSurface(const Primitives& items);
  /// The surface, or nothing if the items are not one.
  static std::optional<GridSurface> of(const Primitives& items);

  const HomogeneousPoint& upward() const { return mark_.upward; }
  std::uint32_t columns() const { return mark_.x_points - 1; }  ///< number of columns of cells
  std::uint32_t rows() const { return mark_.y_points - 1; }
  /// Points (i, j) are numbered row by row.
  std::uint32_t number(std::uint32_t i, std::uint32_t j) const {
    assert(i < mark_.x_points && j < mark_.y_points);
    return j * mark_.x_points + i;
  }
  std::uint32_t points() const { return mark_.x_points * mark_.y_points; }
  const Point3& point(std::uint32_t number) const { return points_[number]; }

  /// The sides of cells, by number: first those along x, then those along y, then the diagonals.
  std::uint32_t side_along_x(std::uint32_t i, std::uint32_t j) const { return j * columns() + i; }
  std::uint32_t side_along_y(std::uint32_t i, std::uint32_t j) const {
    return columns() * mark_.y_points + j * mark_.x_points + i;
  }
  std::uint32_t diagonal(std::uint32_t i, std::uint32_t j) const {
    return columns() * mark_.y_points + mark_.x_points * rows() + j * columns() + i;
  }
  std::uint32_t sides() const { return diagonal(0, rows()); }

  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// The side that ends at this corner of an item's polygon; kNone if it is not the surface's.
  std::uint32_t side(std::uint32_t item, std::uint32_t corner) const;
  /// The item that is the triangle of that cell with the corner (i + 1, j); the next is the other.
  std::uint32_t first_triangle(std::uint32_t i, std::uint32_t j) const {
    assert(i < columns() && j < rows());
    return first_item_ + 2 * (j * columns() + i);
  }
  /// True if the item is a triangle of the surface.
  bool has(std::uint32_t item) const {
    return item >= first_item_ && item - first_item_ < 2 * columns() * rows();
  }
  /// True if the item is the triangle of its cell that has the corner (i + 1, j).
  bool is_first(std::uint32_t item) const {
    assert(has(item));
    return (item - first_item_) % 2 == 0;
  }

 private:
  GridSurface() = default;
  /// Returns an error message, or empty.
  std::string take(const Primitives& items);
  bool take_cell(const Primitives& items, std::uint32_t i, std::uint32_t j);
  static bool is_solid_triangle(const Primitives& items, std::uint32_t number);

  SurfaceMark mark_{};
  std::uint32_t first_item_ = 0;
  std::vector<Point3> points_;
};

}  // namespace displayfile
