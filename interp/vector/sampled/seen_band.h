#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "interp/scan/scan_convert.h"
#include "interp/vector/sampled/collected_drawing.h"
#include "interp/vector/sampled/seen_depths.h"

namespace displayfile {

/// Which polygon is seen at each pixel centre, for a band of the picture's rows and some rows
/// more on either side, decided exactly. Of equal depths the polygon entered later is seen.
class SeenBand {
 public:
  static constexpr std::uint32_t kBackground = CollectedDrawing::kNone;
  /// Rows kept beyond the band, so that what happens at its border can be judged within it.
  static constexpr int kMargin = 20;

  explicit SeenBand(const CollectedDrawing& drawing) : drawing_(drawing) {}

  /// Fills the band's rows first_row <= j < end_row (and the margins) from these polygons, by
  /// index, in any order; those that are not filled are passed over.
  void find(int first_row, int end_row, std::span<const std::uint32_t> polygons);

  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }

  /// Within the band and its margins.
  std::uint32_t seen(int column, int row) const {
    const auto& cell = cells_[index(column, row)];
    return cell.is_background() ? kBackground : begun_[cell.owner];
  }
  /// Of the polygon seen; minus infinity for the background.
  double depth(int column, int row) const { return cells_[index(column, row)].z; }
  int first_row_kept() const { return first_kept_; }
  int end_row_kept() const { return end_kept_; }

  /// Calls run(row, first, end) for each run of pixels, in the band without its margins, whose
  /// centres the polygon covers.
  template <class Run>
  void for_each_run(std::uint32_t polygon, Run&& run) {
    scan_convert(polygon, first_row_, end_row_, run);
  }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row - first_kept_) * static_cast<std::size_t>(drawing_.width) +
           static_cast<std::size_t>(column);
  }
  template <class Run>
  void scan_convert(std::uint32_t polygon, int first_row, int end_row, Run&& run) {
    converter_.scan_convert(drawing_.vertices_of(drawing_.polygons[polygon]),
                            {{drawing_.width, drawing_.height}, first_row, end_row}, run);
  }

  const CollectedDrawing& drawing_;
  int first_row_ = 0, end_row_ = 0, first_kept_ = 0, end_kept_ = 0;
  std::vector<SeenDepths::Cell> cells_;
  std::vector<std::uint32_t> begun_;  // the polygon of each owner
  ScanConverter converter_;
};

/// Hands out, band by band from the bottom, the items (polygons, lines) that reach a band's rows.
class ItemsByRow {
 public:
  struct Rows {
    int first, last;  ///< none if first > last
  };
  explicit ItemsByRow(std::vector<Rows> rows);

  /// The items that reach first_row <= j < end_row, in no order; both bounds may only grow from
  /// call to call. Valid until the next call.
  std::span<const std::uint32_t> reaching(int first_row, int end_row);

 private:
  std::vector<Rows> rows_;
  std::vector<std::uint32_t> by_first_row_, active_;
  std::size_t next_ = 0;
};

}  // namespace displayfile
