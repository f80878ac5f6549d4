#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "clip/point.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

/// A picture's size in pixels, each from 1 to 2^30.
struct PictureSize {
  std::int32_t width, height;
  bool operator==(const PictureSize&) const = default;
};

/// The centre of pixel (column, row), rows counted from the bottom: the point
/// ((column + 1/2) / width, (row + 1/2) / height) in device coordinates, which x and y are
/// close to: each is rounded once.
struct PixelCentre {
  PixelCentre(std::int32_t column_, std::int32_t row_, const PictureSize& size_)
      : column(column_),
        row(row_),
        size(size_),
        x((2.0 * column_ + 1.0) / (2.0 * size_.width)),
        y((2.0 * row_ + 1.0) / (2.0 * size_.height)),
        error(kUnit * std::max(std::abs(x), std::abs(y)) * kInflate) {
    assert(size_.width > 0 && size_.height > 0);
  }

  std::int32_t column, row;
  PictureSize size;
  double x, y;
  double error;  ///< of x and of y, at most
};

// Every predicate here returns the true sign, -1, 0 or 1, for coordinates up to
// kCoordinateLimit, whatever the rounding mode.

int exact_crossing(const Point2& a, const Point2& b, const PixelCentre& centre);
int exact_compare_with_centres(double coordinate, std::int32_t pixels, std::int32_t index);

/// The sign of coordinate * pixels - (index + 1/2): where a vertex's y lies against a row of
/// centres (pixels is the picture's height, index the row), or its x against a column's. It does
/// not fall as the coordinate grows, nor rise as the index does.
///
/// Since rounding is monotonic, the rounded product is never on the wrong side of an odd number:
/// only equality needs more.
inline int compare_with_centres(double coordinate, std::int32_t pixels, std::int32_t index) {
  assert(pixels > 0);
  const double twice = coordinate * (2.0 * pixels);
  const double centre = 2.0 * index + 1.0;
  if (twice != centre) [[likely]]
    return twice > centre ? 1 : -1;
  return exact_compare_with_centres(coordinate, pixels, index);
}

/// The first row, from 0 to height, whose centre is above y: device coordinates. It does not fall
/// as y grows.
inline std::int32_t first_row_above(double y, std::int32_t height) {
  const double t = y * height - 0.5;
  if (t < -0.5) return 0;
  if (!(t < height)) return height;
  const std::int32_t row = static_cast<std::int32_t>(t + 1.0) - 1;  // t's floor
  // The rounded product can be off by less than a row.
  if (row >= 0 && compare_with_centres(y, height, row) < 0) return row;
  return compare_with_centres(y, height, row + 1) < 0 ? row + 1 : std::min(row + 2, height);
}

/// The first column, from 0 to width, whose centre is at or right of x: device coordinates.
inline std::int32_t first_column_from(double x, std::int32_t width) {
  const std::int32_t column = first_row_above(x, width);
  return column > 0 && compare_with_centres(x, width, column - 1) == 0 ? column - 1 : column;
}

/// The sign of the x at which the line through a and b crosses the row of the centre, less the
/// centre's x: the crossing is at or left of the centre where this is not 1. Device
/// coordinates; a.y and b.y must differ, in either order.
///
/// crossing(a, b, centre) = crossing(b, a, centre).
inline int crossing(const Point2& a, const Point2& b, const PixelCentre& centre) {
  assert(a.y != b.y);
  constexpr double kBound = 4.0 * kUnit * kInflate;
  const double run = b.x - a.x, rise = b.y - a.y;
  const double left = (a.x - centre.x) * rise;
  const double right = (a.y - centre.y) * run;
  const double determinant = left - right;
  const double bound =
      kBound * std::abs(left + right) + centre.error * (std::abs(rise) + std::abs(run)) + kTiny;
  if (std::abs(determinant) > bound) [[likely]] {
    return decided_sign(determinant, rise);
  }
  return exact_crossing(a, b, centre);
}

/// The first column, from 0 to width, whose centre lies at or right of that crossing: of the
/// row's centres, those from this column on count the edge. Width if none does. The same for the
/// reversed edge.
std::int32_t first_column_after_crossing(const Point2& a, const Point2& b, std::int32_t row,
                                         const PictureSize& size);

}  // namespace displayfile
