#pragma once

#include <algorithm>

#include "clip/bounds.h"
#include "clip/view.h"

namespace displayfile {

/// The window with this aspect ratio (width over height) around `seen` (view-plane coordinates),
/// with at least a twentieth of it free at each side; its height is at least what that leaves for
/// `least_height`.
inline Rectangle fitted_window(const Bounds& seen, double aspect, double least_height = 0.0) {
  constexpr double kMargin = 0.05;
  const Point3 size = seen.high - seen.low, middle = seen.middle();
  const double half_height =
      0.5 * std::max({size.x / aspect, size.y, least_height}) / (1.0 - 2.0 * kMargin);
  const double half_width = aspect * half_height;
  return {middle.x - half_width, middle.x + half_width, middle.y - half_height,
          middle.y + half_height};
}

}  // namespace displayfile
