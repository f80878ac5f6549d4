#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "clip/point.h"
#include "interp/scan/pixel_set.h"
#include "interp/scan/scan_convert.h"

namespace displayfile {

/// Bounds the displacement of a polygon's boundary by the rounding of its vertices, along x and
/// along y; in pixels, including the rounding of the tests for closeness. Device coordinates.
Point2 boundary_error(std::span<const Point3> polygon, const PictureSize& size);

/// Adds the centres closer than `error` to the polygon's boundary in the rows of its vertices:
/// ScanConverter::watch omits these, since a side does not cross the rows that it only touches. If
/// the error is not small compared with a pixel, adds all centres that the polygon may cover.
void note_rows_of_vertices(std::span<const Point3> polygon, const Point2& error,
                           const PictureSize& size, PixelSet& noted);

/// Some pixel centres, each with the number of the polygon visible there so far.
class NotedCentres {
 public:
  using Owner = std::uint32_t;
  static constexpr Owner kNone = std::numeric_limits<Owner>::max();

  /// The set must outlive this.
  NotedCentres(const PixelSet& centres, const PictureSize& size);

  /// The rows from the first to the last in which the polygon's bounding box has a centre.
  ScanConverter::Region rows_of(std::span<const Point3> polygon) const;

  /// Calls visit(column, owner) for each centre of the run; it may change the owner.
  template <class Visit>
  void in_run(int row, int first, int end, Visit&& visit) {
    const auto at_row = static_cast<std::size_t>(row - centres_.row_begin());
    const std::size_t row_end = row_start_[at_row + 1];
    std::size_t at = row_start_[at_row];
    const auto begin = column_.begin();
    at = static_cast<std::size_t>(std::lower_bound(begin + static_cast<std::ptrdiff_t>(at),
                                                   begin + static_cast<std::ptrdiff_t>(row_end),
                                                   first) -
                                  begin);
    for (; at < row_end && column_[at] < end; ++at) visit(column_[at], owner_[at]);
  }

  /// Calls show(row, column, owner) for each centre.
  template <class Show>
  void for_each(Show&& show) const {
    std::size_t k = 0;
    centres_.for_each([&](int row, int column) { show(row, column, owner_[k++]); });
  }

 private:
  const PixelSet& centres_;
  PictureSize size_;
  std::vector<std::size_t> row_start_;  // of each row's centres in the two that follow
  std::vector<std::int32_t> column_;
  std::vector<Owner> owner_;
};

}  // namespace displayfile
