#include "interp/raster/antialias.h"

#include <algorithm>
#include <utility>

namespace displayfile {

SampleAverage::SampleAverage(int width, int samples, TakeRows take)
    : width_(width),
      samples_(samples),
      take_(std::move(take)),
      sums_(3 * static_cast<std::size_t>(width)) {}

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
  for (std::size_t i = 0; i < sums_.size(); i += 3) {
    for (int k = 0; k < samples_; ++k, ++samples) {
      sums_[i] += *samples & 0xFF;
      sums_[i + 1] += *samples >> 8 & 0xFF;
      sums_[i + 2] += *samples >> 16 & 0xFF;
    }
  }
  ++rows_added_;
}

/// Each component is rounded to the nearest.
void SampleAverage::pass_on(Picture& averaged) {
  const auto of_pixel = static_cast<std::uint32_t>(samples_ * samples_);
  const auto mean = [&](std::uint32_t sum) { return (2 * sum + of_pixel) / (2 * of_pixel); };
  for (std::size_t i = 0; i < sums_.size(); i += 3) {
    averaged.pixels.push_back(0xFF000000u | mean(sums_[i + 2]) << 16 | mean(sums_[i + 1]) << 8 |
                              mean(sums_[i]));
  }
  ++averaged.height;
  rows_added_ = 0;
  std::ranges::fill(sums_, 0u);
}

}  // namespace displayfile
