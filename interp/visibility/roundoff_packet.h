#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "interp/visibility/fill_depths.h"
#include "interp/visibility/ray_square.h"

namespace displayfile {

/// A packet of rays for which depths closer than ROUNDOFF count as equal: each sees the fill
/// entered last of those that it hits within ROUNDOFF of the nearest depth. So the rays are cast
/// twice, first for that depth; and what is seen depends on no order of the hits.
class RoundoffPacket : public RaySquare {
 public:
  RoundoffPacket(const FillDepths& depths, double roundoff)
      : depths_(depths), roundoff_(roundoff) {}

  void begin(const PixelBox& rays) {
    begin_square(rays);
    nearest_.fill(-std::numeric_limits<double>::infinity());
    margin_ = 0.0;
    first_cast_ = true;
    find_farthest();
  }
  /// Of the two casts, the second.
  void begin_second() {
    margin_ = roundoff_;
    first_cast_ = false;
    find_farthest();
  }

  bool hides_all_beyond(float nearest) const { return nearest < farthest_; }
  void begin_fill(Fill fill) { fill_ = fill; }
  void hit(int row, int first, int end) {
    const PixelDepth& depth = depths_.depth(fill_);
    const double row_depth = depth.row(row);
    for (int column = first; column < end; ++column) {
      const double z = depth.at(row_depth, column);
      const std::size_t k = index(row, column);
      if (first_cast_) {
        nearest_[k] = std::max(nearest_[k], z);
      } else if (z >= nearest_[k] - margin_) {
        seen_[k] = std::max(seen_[k], fill_);
      }
    }
  }
  void end_fill() {
    if (first_cast_) find_farthest();
  }

 private:
  void find_farthest() {
    farthest_ = std::numeric_limits<double>::infinity();
    for (int row = rays_.first_row; row < rays_.end_row; ++row) {
      for (int column = rays_.first_column; column < rays_.end_column; ++column) {
        farthest_ = std::min(farthest_, nearest_[index(row, column)] - margin_);
      }
    }
  }

  const FillDepths& depths_;
  double roundoff_;
  std::array<double, kRays> nearest_;
  Fill fill_ = ViewedScene::kBackground;
  double margin_ = 0.0, farthest_ = 0.0;
  bool first_cast_ = true;
};

}  // namespace displayfile
