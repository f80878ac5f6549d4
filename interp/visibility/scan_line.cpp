#include "interp/visibility/scan_line.h"

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
  ActivePolygons active(scene, depths_, size, polygons_, row_begin);
  CloseDepths close(scene, depths_, size);
  SpanSweep sweep(close, size.width);
  std::vector<ViewedScene::Fill> of_row(static_cast<std::size_t>(size.width));
  for (int row = row_begin; row < row_end; ++row) {
    sweep.begin_row(row);
    active.next_row([&](ActivePolygons::Index polygon, int first, int end) {
      sweep.add(active[polygon], polygon, first, end);
    });
    sweep.sweep(of_row, [&](ActivePolygons::Index hidden, ActivePolygons::Index other) {
      const int last_row = hidden_until(active, hidden, other, close);
      if (last_row <= row) return active.may_not_rest(hidden);
      active.rest(hidden, last_row);
      ++counts.rests;
      counts.rows_left += static_cast<std::uint64_t>(last_row - row);
    });
    seen(row, 0, of_row);
  }
  counts.sweep = sweep.counts();
  return counts;
}

/// The last row up to which a polygon certainly stays behind another, or -1: it is within the
/// other, and farther at the corners of the trapezoid between that row and this, so everywhere in
/// it.
int ScanLine::hidden_until(const ActivePolygons& polygons, ActivePolygons::Index hidden,
                           ActivePolygons::Index other, CloseDepths& close) const {
  const auto widths = polygons.stays_within(hidden, other);
  if (!widths) return -1;
  const ActivePolygons::Polygon &behind = polygons[hidden], &seen = polygons[other];
  const double slopes = std::abs(behind.depth.dz_dx) + std::abs(seen.depth.dz_dx);
  const double margin = 2.0 * (behind.error + seen.error);
  for (const ActivePolygons::Width& width : *widths) {
    const double y = width.row + 0.5, off = margin + 2.0 * slopes * width.error;
    for (const double x : {width.left, width.right}) {
      if (seen.depth.at_point(x, y) - behind.depth.at_point(x, y) > off) continue;
      return close.always_hides(seen.fill, behind.fill) ? (*widths)[1].row : -1;
    }
  }
  return (*widths)[1].row;
}

}  // namespace displayfile
