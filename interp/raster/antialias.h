#pragma once

#include <cstdint>
#include <vector>

#include "interp/device/picture.h"
#include "interp/files/row_file.h"

namespace displayfile {

/// Antialiasing by samples x samples centres for each pixel: a picture drawn so many times as
/// large, its colours averaged. Takes its rows from the top and passes on those of the picture; of
/// pixels only. Where there is no background, a pixel that samples cover in part has the mean of
/// their colours, and alpha for the part that they cover.
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
