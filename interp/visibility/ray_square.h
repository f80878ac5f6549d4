#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "displayfile/viewed_scene.h"
#include "interp/scan/pixel_box.h"

namespace displayfile {

/// Neighbouring rays that are cast together, through the centres of a square of pixels or a part
/// of one, and the fill that each sees so far.
class RaySquare {
 public:
  using Fill = ViewedScene::Fill;
  static constexpr int kSide = 8;

  const PixelBox& rays() const { return rays_; }

  /// What the rays of a row see.
  std::span<const Fill> seen(int row) const {
    return std::span(seen_).subspan(
        index(row, rays_.first_column),
        static_cast<std::size_t>(rays_.end_column - rays_.first_column));
  }

 protected:
  static constexpr std::size_t kRays = std::size_t{kSide} * kSide;

  void begin_square(const PixelBox& rays) {
    rays_ = rays;
    seen_.fill(ViewedScene::kBackground);
  }
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>((row - rays_.first_row) * kSide + column - rays_.first_column);
  }

  PixelBox rays_{};
  std::array<Fill, kRays> seen_;
};

}  // namespace displayfile
