#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "interp/picture.h"
#include "interp/scan_convert.h"

namespace displayfile {

inline constexpr std::uint32_t kBackgroundPixel = 0xFFFFFFFF;  // white

/// The rows of a picture that one thread draws. Rows count from the bottom.
struct RasterBand {
  RasterBand(Picture& picture_, int row_begin, int row_end)
      : picture(picture_), region{{picture_.width, picture_.height}, row_begin, row_end} {}

  Picture& picture;
  ScanConverter::Region region;

  const PictureSize& size() const { return region.size; }
  bool contains_row(int row) const { return row >= region.row_begin && row < region.row_end; }
  /// In the picture's arrays.
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(size().height - 1 - row) *
               static_cast<std::size_t>(size().width) +
           static_cast<std::size_t>(column);
  }
  /// Columns first <= i < end of a row.
  void paint(int row, int first, int end, std::uint32_t colour, std::int32_t pick) {
    std::fill_n(picture.pixels.data() + index(row, first), end - first, colour);
    if (!picture.ids.empty()) {
      std::fill_n(picture.ids.data() + index(row, first), end - first, pick);
    }
  }
};

}  // namespace displayfile
