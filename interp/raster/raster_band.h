#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "interp/device/picture.h"
#include "interp/raster/pixel_shade.h"
#include "interp/scan/scan_convert.h"

namespace displayfile {

/// Rows of a picture, counted from the bottom.
struct RowRange {
  int begin, end;
};

/// The rows drawn by one thread, of those in memory: a picture of the rows `held` of the whole one,
/// or of all rows.
struct RasterBand {
  RasterBand(Picture& picture_, const PictureSize& size, std::uint32_t background_,
             const RowRange& held, const RowRange& drawn, const Shadows* shadows_ = nullptr,
             bool shows_fills_ = true, bool crumbs_ = false)
      : picture(picture_),
        background(background_),
        region{size, drawn.begin, drawn.end},
        held_end(held.end),
        shadows(shows_fills_ ? shadows_ : nullptr),
        shows_fills(shows_fills_),
        crumbs(crumbs_) {}

  Picture& picture;
  std::uint32_t background;  ///< as in Picture::pixels
  ScanConverter::Region region;
  int held_end;
  const Shadows* shadows;  ///< null: none
  bool shows_fills;        ///< false: all show the background, by the colour rule
  bool crumbs;             ///< RasterRequest::crumbs

  /// OutputDevice::pixels.
  Point2 pixels() const { return crumbs ? Point2(0.0) : Point2(size().width, size().height); }
  /// The size of the whole picture.
  const PictureSize& size() const { return region.size; }
  /// The index of a pixel in the picture's arrays.
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(held_end - 1 - row) * static_cast<std::size_t>(size().width) +
           static_cast<std::size_t>(column);
  }
  /// Paints the columns first <= i < end of a row.
  void paint(int row, int first, int end, const FillColour& colour, std::int32_t pick) {
    const std::span pixels(picture.pixels.data() + index(row, first),
                           static_cast<std::size_t>(end - first));
    if (shows_fills) {
      colour.paint(row, first, pixels);
    } else {
      std::ranges::fill(pixels, background);
    }
    if (!picture.ids.empty()) {
      std::fill_n(picture.ids.data() + index(row, first), end - first, pick);
    }
  }
};

}  // namespace displayfile
