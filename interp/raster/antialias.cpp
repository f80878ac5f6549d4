#include "interp/raster/antialias.h"

#include <algorithm>
#include <utility>

namespace displayfile {

SampleAverage::SampleAverage(int width, int samples, TakeRows take)
    : width_(width),
      samples_(samples),
      take_(std::move(take)),
      sums_(4 * static_cast<std::size_t>(width)) {}

void SampleAverage::operator()(const Picture& rows) {
  Picture averaged;
  averaged.width = width_;
  const auto width = static_cast<std::size_t>(rows.width);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows.height); ++row) {
    add_row(rows.pixels.data() + row * width);
    if (rows_added_ == samples_) pass_on(averaged);
  }
  if (averaged.height > 0) take_(averaged);
}

void SampleAverage::add_row(const std::uint32_t* samples) {
  for (std::size_t i = 0; i < sums_.size(); i += 4) {
    for (int k = 0; k < samples_; ++k, ++samples) {
      const std::uint32_t alpha = *samples >> 24;
      sums_[i] += alpha * (*samples & 0xFF);
      sums_[i + 1] += alpha * (*samples >> 8 & 0xFF);
      sums_[i + 2] += alpha * (*samples >> 16 & 0xFF);
      sums_[i + 3] += alpha;
    }
  }
  ++rows_added_;
}

/// Averages the samples' colours, weighted by their alpha, and their alpha. Each component is
/// rounded to the nearest.
void SampleAverage::pass_on(Picture& averaged) {
  const auto of_pixel = static_cast<std::uint32_t>(samples_ * samples_);
  const auto divided = [](std::uint32_t sum, std::uint32_t by) {
    return (2 * sum + by) / (2 * by);
  };
  for (std::size_t i = 0; i < sums_.size(); i += 4) {
    const std::uint32_t covered = sums_[i + 3], by = std::max(covered, 1u);
    averaged.pixels.push_back(divided(covered, of_pixel) << 24 | divided(sums_[i + 2], by) << 16 |
                              divided(sums_[i + 1], by) << 8 | divided(sums_[i], by));
  }
  ++averaged.height;
  rows_added_ = 0;
  std::ranges::fill(sums_, 0u);
}

}  // namespace displayfile
