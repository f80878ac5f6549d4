#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "interp/visibility/decided_run.h"
#include "interp/visibility/fill_depths.h"
#include "interp/visibility/pair_orders.h"

namespace displayfile {

/// The one-row z-buffer of the scan-line z-buffer: the depth and the visible fill at each pixel of
/// one row. Fills are compared as in FillDepths, but for many pixels together where exact
/// arithmetic is needed (interp/visibility/scan_line_z.md).
class DepthRow {
 public:
  using Fill = ViewedScene::Fill;

  DepthRow(const ViewedScene& scene, const PictureSize& size, std::optional<double> roundoff);

  /// Clears it for a row.
  void begin(int row);

  /// The next fill of the row, entered later than those before it.
  void begin_fill(Fill fill, const FillDepth& depth);

  /// Covers columns first <= i < end with the fill begun.
  void draw_span(int first, int end);

  /// The visible fills. Must be called once per row, after all are drawn.
  std::span<const Fill> seen();

 private:
  /// A fill of the row, by its index among them.
  using Owner = std::uint32_t;
  static constexpr Owner kBackground = 0;
  struct Drawn {
    Fill fill;
    double error;
  };
  /// Columns of a span from `column` on, up to `end`.
  struct Rest {
    int column, end;
  };
  bool hides_closely(double nearer, const Rest& rest);
  DecidedRun decided_run(const Rest& rest);
  int end_of_run(const Rest& rest) const;

  PictureSize size_;
  const bool exact_;
  int row_ = 0;
  std::vector<double> depth_;
  std::vector<Owner> owner_;
  std::vector<Drawn> drawn_;     // in this row; the background first
  double largest_error_ = 0.0;   // of them
  FillDepth current_;            // of the last of them
  DecidedRun run_{0, 0, false};  // of the span being drawn
  PairOrders orders_;
};

}  // namespace displayfile
