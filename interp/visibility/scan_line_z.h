#pragma once

#include <optional>
#include <vector>

#include "interp/visibility/image_space.h"

namespace displayfile {

/// The scan-line z-buffer (Carpenter): all polygons are scan-converted together, row by row, so
/// that the z-buffer is a single row of depths and fills (interp/visibility/scan_line_z.md). In
/// addition it keeps 12 bytes a polygon, and the polygons that reach the row; no memory depends on
/// the picture's height.
class ScanLineZ : public ImageSpaceMethod {
 public:
  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override;
  /// The polygons that reach the first row are found without examining all of them.
  int rows_at_a_time() const override { return 16; }

 private:
  using Fill = ViewedScene::Fill;

  /// A row of the polygon table: the picture rows that the fill crosses, first_row <= row <
  /// end_row.
  struct Polygon {
    Fill fill;
    int first_row, end_row;
  };
  class Sweep;

  std::optional<Request> request_;
  std::vector<Polygon> table_;      // by first row, those of a row by fill
  std::vector<int> block_end_row_;  // the last end_row in each block of the table
};

}  // namespace displayfile
