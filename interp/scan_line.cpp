#include "interp/scan_line.h"

#include <cmath>
#include <vector>

namespace displayfile {

void ScanLine::prepare(const Request& request, int /*threads*/) {
  request_.emplace(request);
  depths_ = FillDepths(request.scene, request.size, request.roundoff);
  polygons_ = PolygonList(request.scene, request.size.height);
}

ScanLine::Counts ScanLine::draw_rows_counting(int row_begin, int row_end,
                                              const SeenRun& seen) const {
  const auto& [scene, size, roundoff] = *request_;
  Counts counts;
  ActivePolygons active(scene, size, polygons_, row_begin);
  PairOrders close(scene, depths_, !roundoff);
  SpanSweep sweep(depths_, close, size.width);
  std::vector<FillScene::Fill> of_row(static_cast<std::size_t>(size.width));
  for (int row = row_begin; row < row_end; ++row) {
    sweep.begin_row(row);
    active.next_row([&](FillScene::Fill fill, int first, int end, ActivePolygons::Index polygon) {
      sweep.add(fill, first, end, polygon);
    });
    sweep.sweep(of_row, [&](ActivePolygons::Index hidden, ActivePolygons::Index other) {
      const int last_row = hidden_until(active, hidden, other, close);
      if (last_row <= row) return;
      active.rest(hidden, last_row);
      ++counts.rests;
      counts.rows_left += static_cast<std::uint64_t>(last_row - row);
    });
    seen(row, 0, of_row);
  }
  counts.sweep = sweep.counts();
  return counts;
}

/// The last row up to which a polygon is certain to stay behind another, or -1: it is within the
/// other, and farther at the corners of the trapezoid between that row and this, so in all of it.
int ScanLine::hidden_until(const ActivePolygons& polygons, ActivePolygons::Index hidden,
                           ActivePolygons::Index other, PairOrders& close) const {
  const auto widths = polygons.stays_within(hidden, other);
  if (!widths) return -1;
  const FillScene::Fill behind = polygons.fill(hidden), seen = polygons.fill(other);
  const PixelDepth &of_behind = depths_.depth(behind), &of_seen = depths_.depth(seen);
  const double slopes = std::abs(of_behind.dz_dx) + std::abs(of_seen.dz_dx);
  const double margin = 2.0 * (depths_.error(behind) + depths_.error(seen));
  for (const ActivePolygons::Width& width : *widths) {
    const double y = width.row + 0.5, off = margin + 2.0 * slopes * width.error;
    for (const double x : {width.left, width.right}) {
      if (of_seen.at_point(x, y) - of_behind.at_point(x, y) > off) continue;
      return close.always_hides(seen, behind) ? (*widths)[1].row : -1;
    }
  }
  return (*widths)[1].row;
}

}  // namespace displayfile
