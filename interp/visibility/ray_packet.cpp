#include "interp/visibility/ray_packet.h"

#include <algorithm>
#include <limits>

namespace displayfile {

/// Where the square has no rays, nothing is waited for.
void RayPacket::begin(const PixelBox& rays) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  begin_square(rays);
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

/// Of a depth that is no number the error is infinite, and then nothing is known to be hidden.
void RayPacket::find_farthest() {
  std::array<double, kSide> least;
  std::copy_n(z_.begin(), kSide, least.begin());
  for (std::size_t row = kSide; row < kRays; row += kSide) {
    for (std::size_t k = 0; k < kSide; ++k) {
      const double z = z_[row + k];
      least[k] = z < least[k] ? z : least[k];
    }
  }
  farthest_ = *std::min_element(least.begin(), least.end()) - 2.0 * largest_error_;
  changed_ = false;
}

}  // namespace displayfile
