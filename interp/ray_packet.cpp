#include "interp/ray_packet.h"

#include <algorithm>
#include <limits>

#include "interp/close_planes.h"

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

/// What the rounded depths do not tell: first the two fills' own errors instead of the largest,
/// then whether they lie in one plane, asked once for all rays.
bool RayPacket::hides_closely(Fill other, int column, int row) {
  if (other == FillScene::kBackground) return true;
  const double nearer = depths_.at(fill_, column, row) - depths_.at(other, column, row);
  const double margin = 2.0 * (depths_.error(fill_) + depths_.error(other));
  if (nearer > margin) return true;
  if (nearer < -margin) return false;
  if (compared_ != std::array{fill_, other}) {
    compared_ = {fill_, other};
    coplanar_ = are_one_plane(scene_.plane(fill_), scene_.plane(other));
  }
  return coplanar_ ? fill_ > other : depths_.hides(fill_, other, column, row);
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
