#include "interp/scan/pixel_box.h"

namespace displayfile {

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
