#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/scan/sort_stably.h"

namespace displayfile {

/// A side of a polygon that crosses the rows first_row to last_row, in pixel units; where it
/// crosses them is decided exactly (interp/scan/scan_convert.md).
struct ScanEdge {
  int first_row, last_row;
  double x, y, dx_dy;  ///< the lower end, and the change of x for each row
  double error;        ///< bounds the error of a crossing, including the watched distance
  Point2 low, high;    ///< the ends in device coordinates

  /// The side between two points of different height.
  ScanEdge(const Point2& low_, const Point2& high_, int first_row_, int last_row_,
           const PictureSize& size)
      : first_row(first_row_), last_row(last_row_), low(low_), high(high_) {
    const Point2 a(low.x * size.width, low.y * size.height);
    const Point2 b(high.x * size.width, high.y * size.height);
    const double rise = b.y - a.y, heights = std::abs(a.y) + std::abs(b.y);
    x = a.x;
    y = a.y;
    dx_dy = (b.x - a.x) / rise;
    // interp/scan/scan_convert.md derives the bound.
    error = rise > 8.0 * kUnit * heights
                ? 16.0 * kUnit * (std::abs(a.x) + std::abs(b.x) + std::abs(dx_dy) * heights)
                : std::numeric_limits<double>::infinity();
  }

  /// The first column whose centre lies at or right of where the edge crosses the row. Calls
  /// close(*this, row) if a centre is closer to the crossing than its error.
  template <class Close>
  int column(int row, const PictureSize& size, Close&& close) const;
  int column(int row, const PictureSize& size) const {
    return column(row, size, [](const ScanEdge&, int) {});
  }
};

/// The textbook adds dx_dy row by row; one product from the edge's lower end gives the same
/// crossing without accumulated error, whatever the first row. Where a centre is too close to the
/// rounded crossing, exact arithmetic decides.
template <class Close>
int ScanEdge::column(int row, const PictureSize& size, Close&& close) const {
  if (!(error < 0.25)) [[unlikely]] {
    close(*this, row);
    return first_column_after_crossing(low, high, row, size);
  }
  const double t = x + (row + 0.5 - y) * dx_dy - 0.5;
  if (t < -error) return 0;
  if (t > size.width + error) return size.width;
  const int floor = static_cast<int>(t + 1.0) - 1;
  const double fraction = t - floor;
  if (!(fraction > error && fraction < 1.0 - error)) [[unlikely]] {
    close(*this, row);
    return first_column_after_crossing(low, high, row, size);
  }
  return std::min(floor + 1, size.width);
}

/// Appends the edges of a polygon (device coordinates) that cross rows row_begin <= row < row_end,
/// as far as they do, by first row.
inline void append_edges(std::span<const Point3> polygon, const PictureSize& size, int row_begin,
                         int row_end, std::vector<ScanEdge>& edges) {
  const std::size_t start = edges.size();
  Point2 from(polygon.back());
  int from_row = first_row_above(from.y, size.height);
  for (const Point3& vertex : polygon) {
    const Point2 to(vertex);
    const int to_row = first_row_above(to.y, size.height);
    const int first = std::max(std::min(from_row, to_row), row_begin);
    const int last = std::min(std::max(from_row, to_row), row_end) - 1;
    if (first <= last) {
      const Point2& low = from_row < to_row ? from : to;
      const Point2& high = from_row < to_row ? to : from;
      edges.emplace_back(low, high, first, last, size);
    }
    from = to;
    from_row = to_row;
  }
  sort_stably(std::span(edges).subspan(start), &ScanEdge::first_row);
}

}  // namespace displayfile
