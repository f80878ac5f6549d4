#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "clip/point.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/scan/scan_edge.h"

namespace displayfile {

/// Scan conversion of polygons (the textbook's chapter 3): an edge table, an active edge
/// list, and even-odd filling between pairs of edges. The decisions are exact
/// (interp/scan/scan_convert.md).
///
/// Pixel (i, j) has its centre at (i + 1/2, j + 1/2) in pixel units, j counted from the bottom.
/// An edge crosses the rows with min y < j + 1/2 <= max y; a pixel is covered if an odd number
/// of edges cross its row at or left of its centre. So a centre on a left or top edge belongs
/// to the polygon, one on a right or bottom edge does not, and of two polygons that share an
/// edge exactly one covers a centre on it.
class ScanConverter {
 public:
  /// The rows that are converted, of a picture of this size.
  struct Region {
    PictureSize size;
    int row_begin, row_end;
  };

  /// The rows that a polygon crosses within a region; none if first == end.
  struct Rows {
    int first, end;
  };

  /// Begins a polygon (device coordinates) of any number of vertices; it may be concave or cross
  /// itself.
  Rows begin(std::span<const Point3> polygon, const Region& region);

  /// For the polygon begun, scan() also reports which centres may lie this close (in pixels, along
  /// x and along y) to a side that crosses their row.
  void watch(const Point2& distance);

  /// Ignores the centres that are close to a side.
  struct Unwatched {
    void operator()(int, int, int) const {}
  };

  /// Calls fill_span(row, first, end) for each run of covered pixels of the polygon begun, row by
  /// row from the bottom, left to right; if it is watched, close(row, first, end) for each run of
  /// close ones, in any order and more than once.
  template <class FillSpan, class Close = Unwatched>
  void scan(FillSpan&& fill_span, Close&& close = {});

  /// begin and scan in one call.
  template <class FillSpan>
  void scan_convert(std::span<const Point3> polygon, const Region& region, FillSpan&& fill_span) {
    begin(polygon, region);
    scan(fill_span);
  }

 private:
  /// Calls close(row, first, end) with the centres within the edge's error of its crossing.
  template <class Close>
  void tell_close(const ScanEdge& edge, int row, Close&& close) const;

  Region region_{};
  Point2 watched_{0.0};
  std::vector<ScanEdge> edges_;  // the edge table, by first row
  std::vector<const ScanEdge*> active_;
  std::vector<int> columns_;
};

inline ScanConverter::Rows ScanConverter::begin(std::span<const Point3> polygon,
                                                const Region& region) {
  region_ = region;
  edges_.clear();
  append_edges(polygon, region.size, region.row_begin, region.row_end, edges_);
  if (edges_.empty()) return {0, 0};
  const int last = std::ranges::max_element(edges_, {}, &ScanEdge::last_row)->last_row;
  return {edges_.front().first_row, last + 1};
}

/// Also uses exact arithmetic where the watched distance alone separates a crossing from a centre:
/// rows without doubtful centres cost nothing extra.
inline void ScanConverter::watch(const Point2& distance) {
  watched_ = distance;
  const auto& [width, height] = region_.size;
  for (ScanEdge& edge : edges_) {
    const double rise = edge.high.y * height - edge.y;
    edge.error = rise > 8.0 * distance.y
                     ? edge.error + distance.x + 2.0 * std::abs(edge.dx_dy) * distance.y
                     : std::numeric_limits<double>::infinity();
  }
}

template <class Close>
void ScanConverter::tell_close(const ScanEdge& edge, int row, Close&& close) const {
  const double width = region_.size.width;
  const auto [left, right] = std::minmax(edge.low.x, edge.high.x);
  const double crossing = edge.x + (row + 0.5 - edge.y) * edge.dx_dy - 0.5;
  // The ends first: the crossing may not be a number.
  const double from = std::max(left * width - 0.5 - watched_.x, crossing - edge.error);
  const double to = std::min(right * width - 0.5 + watched_.x, crossing + edge.error);
  close(row, static_cast<int>(std::clamp(std::ceil(from), 0.0, width)),
        static_cast<int>(std::clamp(std::floor(to) + 1.0, 0.0, width)));
}

template <class FillSpan, class Close>
void ScanConverter::scan(FillSpan&& fill_span, Close&& close) {
  const auto column_of = [&](const ScanEdge& edge, int at_row) {
    return edge.column(at_row, region_.size, [&](const ScanEdge& crossed, int crossed_row) {
      if constexpr (!std::is_same_v<std::remove_cvref_t<Close>, Unwatched>) {
        tell_close(crossed, crossed_row, close);
      }
    });
  };
  active_.clear();
  std::size_t next = 0;  // in the edge table
  int row = 0;
  while (next < edges_.size() || !active_.empty()) {
    // Bring the active edge list up to this row; it then holds until `last`.
    if (active_.empty()) row = edges_[next].first_row;
    while (next < edges_.size() && edges_[next].first_row == row)
      active_.push_back(&edges_[next++]);
    int last = next < edges_.size() ? edges_[next].first_row - 1 : region_.row_end - 1;
    for (const ScanEdge* edge : active_) last = std::min(last, edge->last_row);

    for (; row <= last; ++row) {
      if (active_.size() == 2) {
        const int a = column_of(*active_[0], row), b = column_of(*active_[1], row);
        if (a != b) fill_span(row, std::min(a, b), std::max(a, b));
        continue;
      }
      columns_.clear();
      for (const ScanEdge* edge : active_) columns_.push_back(column_of(*edge, row));
      std::ranges::sort(columns_);
      for (std::size_t k = 0; k + 1 < columns_.size(); k += 2) {
        if (columns_[k] < columns_[k + 1]) fill_span(row, columns_[k], columns_[k + 1]);
      }
    }
    std::erase_if(active_, [&](const ScanEdge* edge) { return edge->last_row < row; });
  }
}

}  // namespace displayfile
