#include "interp/scan/pixel_box.h"

#include "interp/scan/scan_edge.h"

namespace displayfile {

namespace {

/// The first column whose centre is at x (device) or right of it, from 0 to the width.
int first_column_from(double x, int width) {
  const int column = first_row_above(x, width);
  return column > 0 && compare_with_centres(x, width, column - 1) == 0 ? column - 1 : column;
}

}  // namespace

PixelBox extents_of(std::span<const Point3> polygon, const PictureSize& size) {
  Point2 low(polygon[0]), high = low;
  for (const Point3& v : polygon) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y)};
  }
  return {first_column_from(low.x, size.width), first_column_from(high.x, size.width),
          first_row_above(low.y, size.height), first_row_above(high.y, size.height)};
}

}  // namespace displayfile
