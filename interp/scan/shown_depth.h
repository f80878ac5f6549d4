#pragma once

#include "hidden/exact/pixel_centre.h"
#include "interp/scan/pixel_depth.h"

namespace displayfile {

/// A plane's depth at pixel centres, as returned by depth pictures and picking: that of PixelDepth
/// if its error is at most 2^-40, absolute or relative. Elsewhere, as where the plane of a needle
/// is nearly edge-on, it is the true depth, rounded.
class ShownDepth {
 public:
  ShownDepth() = default;
  /// A plane in normalised device coordinates, not edge-on.
  ShownDepth(const Plane& plane, const PictureSize& size);

  /// At the centre of a pixel, rows counted from the bottom.
  double at(int column, int row) const {
    const double z = depth_.at(depth_.row(row), column);
    return is_close_everywhere_ ? z : checked(z, column, row);
  }

 private:
  double error(double dx, double dy) const {
    return depth_.error(plane_, size_.width, size_.height, dx, dy);
  }
  double checked(double z, int column, int row) const;

  Plane plane_;
  PictureSize size_{1, 1};
  PixelDepth depth_;
  bool is_close_everywhere_ = true;
};

}  // namespace displayfile
