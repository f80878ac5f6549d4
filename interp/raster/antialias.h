#pragma once

#include <cstdint>
#include <vector>

#include "interp/device/picture.h"
#include "interp/files/row_file.h"

namespace displayfile {

/// Antialiasing by samples x samples centres per pixel: averages the colours of a picture drawn
/// that many times as large. Receives its rows from the top and passes on those of the picture;
/// pixels only. Without a background, a partly covered pixel has the mean of its samples' colours,
/// and the covered fraction as alpha.
class SampleAverage {
 public:
  /// The width of the picture passed on.
  SampleAverage(int width, int samples, TakeRows take);

  void operator()(const Picture& rows);

 private:
  void add_row(const std::uint32_t* samples);
  void pass_on(Picture& averaged);

  int width_, samples_;
  TakeRows take_;
  std::vector<std::uint32_t> sums_;  // red, green, blue, alpha of each pixel of the row begun
  int rows_added_ = 0;
};

}  // namespace displayfile
