#pragma once

#include <algorithm>
#include <span>

#include "clip/point.h"
#include "hidden/pixel_centre.h"

namespace displayfile {

/// A sample area of a picture: the centres of the pixels (column, row) of a rectangle, rows counted
/// from the bottom.
struct SampleArea {
  int column_begin, column_end, row_begin, row_end;

  int columns() const { return column_end - column_begin; }
  int rows() const { return row_end - row_begin; }
  bool is_empty() const { return columns() <= 0 || rows() <= 0; }
  bool is_pixel() const { return columns() == 1 && rows() == 1; }
  bool contains(const SampleArea& other) const {
    return column_begin <= other.column_begin && other.column_end <= column_end &&
           row_begin <= other.row_begin && other.row_end <= row_end;
  }
  bool operator==(const SampleArea&) const = default;
};

inline SampleArea intersection(const SampleArea& a, const SampleArea& b) {
  return {std::max(a.column_begin, b.column_begin), std::min(a.column_end, b.column_end),
          std::max(a.row_begin, b.row_begin), std::min(a.row_end, b.row_end)};
}

/// How a polygon lies to a sample area (the problem book's section 10.6). Areas are made of
/// centres, so a polygon surrounds one if it covers all of its centres, and is disjoint from it if
/// it covers none.
enum class AreaCategory { surrounding, intersecting, contained, disjoint };

/// The minimax test's rectangle: holds all centres that the polygon (device coordinates) covers;
/// empty if there are none between its least and greatest x and y.
SampleArea extents_of(std::span<const Point3> polygon, const PictureSize& size);

/// True if the polygon covers the centre by the definition (the design's section 4): exact.
bool covers(std::span<const Point3> polygon, const PixelCentre& centre);

/// The category of a polygon with these extents. Surrounding and disjoint are never said in error;
/// where rounding leaves open whether a side passes by the area, the polygon is intersecting, which
/// decides nothing. Of a pixel it is exact: surrounding or disjoint.
AreaCategory category_of(std::span<const Point3> polygon, const SampleArea& extents,
                         const SampleArea& area, const PictureSize& size);

}  // namespace displayfile
