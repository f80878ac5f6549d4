#pragma once

#include <algorithm>

#include "clip/point.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// True if a triangle in device coordinates certainly covers no pixel centre, of the few in its
/// corners' box: those of `columns` columns from `column` on and `rows` rows from `row` on. A
/// centre farther outside of a side than the rounding error is not covered; undecided ones may be.
///
/// The error: on a picture of up to 65535 pixels a side a corner's place in pixels is off by less
/// than 2^-36, and values computed for sides of up to a few pixels by less than 2^-30.
inline bool covers_none_of_few(const Point3& a, const Point3& b, const Point3& c,
                               const PictureSize& size, std::int32_t column, std::int32_t columns,
                               std::int32_t row, std::int32_t rows) {
  constexpr double kSlack = 0x1p-30;
  const double left = column + 0.5, bottom = row + 0.5;
  const double ax = a.x * size.width - left, ay = a.y * size.height - bottom;
  const double bx = b.x * size.width - left, by = b.y * size.height - bottom;
  const double cx = c.x * size.width - left, cy = c.y * size.height - bottom;
  const double turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0.0 ? -1.0 : 1.0;
  // The signed distance of the first centre to each side, and its increments per column and row.
  const double of_ab = turn * (ax * by - ay * bx), of_bc = turn * (bx * cy - by * cx),
               of_ca = turn * (cx * ay - cy * ax);
  const double ab_x = turn * (ay - by), bc_x = turn * (by - cy), ca_x = turn * (cy - ay);
  const double ab_y = turn * (bx - ax), bc_y = turn * (cx - bx), ca_y = turn * (ax - cx);
  for (std::int32_t j = 0; j < rows; ++j) {
    for (std::int32_t i = 0; i < columns; ++i) {
      const double inside = std::min(
          {of_ab + i * ab_x + j * ab_y, of_bc + i * bc_x + j * bc_y, of_ca + i * ca_x + j * ca_y});
      if (inside >= -kSlack) return false;
    }
  }
  return true;
}

}  // namespace displayfile
