#include "interp/scan/shown_depth.h"

#include <algorithm>
#include <cmath>

#include "hidden/exact/depth_order.h"

namespace displayfile {

namespace {

constexpr double kMostError = 0x1p-40;

}  // namespace

ShownDepth::ShownDepth(const Plane& plane, const PictureSize& size)
    : plane_(plane), size_(size), depth_(plane, size.width, size.height) {
  const auto farthest = [](double origin, int pixels) {
    return std::max(std::abs(origin), std::abs(pixels - origin));
  };
  const double most = error(farthest(depth_.x0, size.width), farthest(depth_.y0, size.height));
  is_close_everywhere_ = most <= kMostError;
}

double ShownDepth::checked(double z, int column, int row) const {
  const double own = error(std::abs(column + 0.5 - depth_.x0), std::abs(row + 0.5 - depth_.y0));
  if (own <= kMostError * std::max(1.0, std::abs(z))) return z;
  return exact_depth(plane_, PixelCentre(column, row, size_));
}

}  // namespace displayfile
