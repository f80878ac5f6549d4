#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "interp/scan/scan_convert.h"
#include "interp/vector/sampled/sampled_scene.h"
#include "interp/visibility/z_buffer.h"

namespace displayfile {

/// Which fill is seen at each pixel centre, for a band of the picture's rows and some rows more on
/// either side, as the z-buffer tells it.
class SeenBand {
 public:
  using Fill = ViewedScene::Fill;
  /// Rows kept beyond the band, so that what happens at its border can be judged within it.
  static constexpr int kMargin = 20;

  explicit SeenBand(const SampledScene& drawing);

  /// Fills the band's rows first_row <= j < end_row, and the margins.
  void find(int first_row, int end_row);

  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }

  /// Within the band and its margins.
  Fill seen(int column, int row) const { return seen_[index(column, row)]; }
  /// The depth of the fill seen; minus infinity for the background.
  double depth(int column, int row) const {
    const Fill fill = seen(column, row);
    if (fill == ViewedScene::kBackground) return -std::numeric_limits<double>::infinity();
    const PixelDepth& depth = drawing_.depths[fill].plane;
    return depth.at(depth.row(row), column);
  }
  int first_row_kept() const { return first_kept_; }
  int end_row_kept() const { return end_kept_; }

  /// Calls run(row, first, end) for each run of pixels, in the band without its margins, whose
  /// centres the fill covers.
  template <class Run>
  void for_each_run(Fill fill, Run&& run) {
    converter_.scan_convert(drawing_.scene.vertices(fill), {drawing_.size, first_row_, end_row_},
                            run);
  }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row - first_kept_) *
               static_cast<std::size_t>(drawing_.size.width) +
           static_cast<std::size_t>(column);
  }

  const SampledScene& drawing_;
  ZBuffer z_buffer_;
  int first_row_ = 0, end_row_ = 0, first_kept_ = 0, end_kept_ = 0;
  std::vector<Fill> seen_;
  ScanConverter converter_;
};

/// Hands out, band by band from the bottom, which of some things (fills, lines), by their numbers,
/// reach a band's rows.
class ActiveByRow {
 public:
  struct Rows {
    int first, last;  ///< none if first > last
  };
  explicit ActiveByRow(std::vector<Rows> rows);

  /// Those that reach first_row <= j < end_row, in no order; both bounds may only grow from
  /// call to call. Valid until the next call.
  std::span<const std::uint32_t> reaching(int first_row, int end_row);

 private:
  std::vector<Rows> rows_;
  std::vector<std::uint32_t> by_first_row_, active_;
  std::size_t next_ = 0;
};

/// The rows of a picture so high that a polygon (device coordinates) reaches.
ActiveByRow::Rows rows_reached(std::span<const Point3> polygon, int height);

}  // namespace displayfile
