#include "interp/visibility/ray_packet.h"

#include <algorithm>
#include <limits>

namespace displayfile {

/// Places of the square without rays get an infinite depth, so that they never count as farthest.
void RayPacket::begin(const PixelBox& rays) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  rays_ = rays;
  cast_ = is_cast_once() ? Cast::for_fills : Cast::for_depths;
  seen_.fill(ViewedScene::kBackground);
  z_.fill(kInfinity);
  for (int row = rays.first_row; row < rays.end_row; ++row) {
    for (int column = rays.first_column; column < rays.end_column; ++column) {
      z_[index(row, column)] = -kInfinity;
    }
  }
  largest_error_ = 0.0;
  farthest_ = -kInfinity;
  changed_ = false;
}

/// Keeps the depths of the first cast: they are the nearest.
bool RayPacket::begin_next_cast() {
  if (cast_ == Cast::for_fills) return false;
  cast_ = Cast::for_fills;
  seen_.fill(ViewedScene::kBackground);
  largest_error_ = FillDepth::error_of_roundoff(*depths_.roundoff());
  find_farthest();
  return true;
}

/// If a depth is NaN its error is infinite, and then nothing is known to be hidden.
void RayPacket::find_farthest() {
  std::array<double, kSide> least;
  std::copy_n(z_.begin(), kSide, least.begin());
  for (std::size_t row = kSide; row < kRays; row += kSide) {
    for (std::size_t k = 0; k < kSide; ++k) {
      const double z = z_[row + k];
      least[k] = z < least[k] ? z : least[k];
    }
  }
  farthest_ = *std::min_element(least.begin(), least.end()) - 4.0 * largest_error_;
  changed_ = false;
}

}  // namespace displayfile
