#pragma once

#include <cstdint>
#include <optional>

#include "interp/visibility/active_polygons.h"
#include "interp/visibility/fill_depths.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/span_sweep.h"

namespace displayfile {

/// The spanning scan line without a z-buffer: on each scan line the polygons are compared only
/// where spans begin and end, and a pixel is painted once (interp/visibility/scan_line.md). With a
/// ROUNDOFF depths are compared as the textbook's SIGNOF does.
///
/// The textbook's chapter 9, "Scan-line algorithms"; the lecture's section 4; the problem book's
/// section 10.5. Its cost is described in interp/visibility/scan_line.md.
class ScanLine : public ImageSpaceMethod {
 public:
  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override {
    draw_rows_counting(row_begin, row_end, seen);
  }
  /// For each call, the polygons that cross the first row are entered again, and their order is
  /// found anew.
  int rows_at_a_time() const override { return 64; }

  struct Counts {
    SpanSweep::Counts sweep;
    std::uint64_t rests = 0;      ///< polygons skipped for some rows: hidden on all of them
    std::uint64_t rows_left = 0;  ///< the rows skipped, in total
  };
  /// Draws the rows, and returns counts of the work.
  Counts draw_rows_counting(int row_begin, int row_end, const SeenRun& seen) const;

 private:
  int hidden_until(const ActivePolygons& polygons, ActivePolygons::Index hidden,
                   ActivePolygons::Index other, CloseDepths& close) const;

  std::optional<Request> request_;
  FillDepths depths_;
  PolygonList polygons_;
};

}  // namespace displayfile
