#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "interp/visibility/row_fills.h"

namespace displayfile {

/// The depths and fills of some rows of a picture. Rows lie `stride` apart and may be written up
/// to their stride.
struct DepthRows {
  static constexpr int kMostRows = 16;
  static constexpr std::size_t kPadding = 16;  ///< columns beyond the picture's

  int row_begin, row_end;  ///< no more than kMostRows
  int width;
  std::size_t stride;
  float* z;                 ///< minus infinity: background; NaN: of a fill that is not certain
  ViewedScene::Fill* fill;  ///< ViewedScene::kBackground: none

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row - row_begin) * stride + static_cast<std::size_t>(column);
  }
};

/// The depth of a fill less that of one drawn before it, times some positive number: z + dz_dx i +
/// dz_dy j at column i of row j of the picture, about 1 where it is largest.
struct DepthDifference {
  ViewedScene::Fill from = ViewedScene::kBackground;  ///< the one drawn before
  double z = 0.0, dz_dx = 0.0, dz_dy = 0.0;
  /// Bounds the error of what single precision makes of it.
  float error = 0.0F;
};

/// What the depths in single precision leave undecided.
class ExactRows {
 public:
  using Fill = ViewedScene::Fill;
  struct Span {
    int row, first, end;
  };

  virtual ~ExactRows() = default;
  /// The fill that is drawn until the next call.
  virtual void begin(Fill fill) = 0;
  /// Where the fill begun covers centres of these rows; valid until the next call.
  virtual std::span<const Span> spans(int row_begin, int row_end) = 0;
  /// Between the fill begun and another, by what is known of the two now.
  virtual DepthDifference difference_from(Fill other) = 0;
  /// Draws those pixels of a row, from `column`, whose bits are set: the fill begun covers them,
  /// and each shows another. True if more is known of two fills than before.
  virtual bool draw(int row, int column, std::uint32_t bits) = 0;
};

/// Draws the fills, given in order of entry, into rows that were cleared or drawn into before.
/// In the widest vectors that the processor has; the fills seen are the same with any.
void draw_into_rows(const RowFills& fills, std::span<const ViewedScene::Fill> to_draw,
                    const DepthRows& rows, ExactRows& exact);

/// The same with rounded decisions only, to measure what the exact ones cost.
void draw_into_rows_rounded(const RowFills& fills, std::span<const ViewedScene::Fill> to_draw,
                            const DepthRows& rows, ExactRows& exact);

}  // namespace displayfile
