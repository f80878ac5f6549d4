#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "clip/point.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// Pixel centres: those of columns first_column <= i < end_column and rows first_row <= j <
/// end_row, rows counted from the bottom.
struct PixelBox {
  std::int32_t first_column, end_column, first_row, end_row;

  int columns() const { return end_column - first_column; }
  int rows() const { return end_row - first_row; }
  bool empty() const { return columns() <= 0 || rows() <= 0; }
  bool contains(const PixelBox& other) const {
    return first_column <= other.first_column && other.end_column <= end_column &&
           first_row <= other.first_row && other.end_row <= end_row;
  }
  bool operator==(const PixelBox&) const = default;
};

inline PixelBox intersection(const PixelBox& a, const PixelBox& b) {
  return {std::max(a.first_column, b.first_column), std::min(a.end_column, b.end_column),
          std::max(a.first_row, b.first_row), std::min(a.end_row, b.end_row)};
}

/// The minimax test's rectangle: the centres between the polygon's least and greatest x and y
/// (device coordinates), which hold all that it covers, and no row or column more.
PixelBox extents_of(std::span<const Point3> polygon, const PictureSize& size);

}  // namespace displayfile
