#pragma once

#include "clip/point.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// A plane in the picture, in exact numbers: a x + b y + c z + d = 0 in device coordinates. As
/// entered, it is not the plane through three points of a display file, which viewing rounded.
struct PlaneInPicture {
  ExactNumber a, b, c, d;
  bool is_edge_on() const { return c.sign() == 0; }
};

/// The line parallel to z through (x / w, y / w), by exact numbers; w is positive.
struct ExactProjector {
  explicit ExactProjector(const Point2& at) : x(at.x), y(at.y), w(1.0) {}
  /// Through a pixel's centre, without its quotients.
  explicit ExactProjector(const PixelCentre& centre)
      : x(ExactNumber(2 * std::int64_t{centre.column} + 1) *
          ExactNumber(std::int64_t{centre.size.height})),
        y(ExactNumber(2 * std::int64_t{centre.row} + 1) *
          ExactNumber(std::int64_t{centre.size.width})),
        w(ExactNumber(2 * std::int64_t{centre.size.width}) *
          ExactNumber(std::int64_t{centre.size.height})) {}

  ExactNumber x, y, w;
};

}  // namespace displayfile
