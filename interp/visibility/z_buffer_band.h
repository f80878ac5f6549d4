#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "interp/visibility/row_fills.h"

namespace displayfile {

// The heart of the z-buffer: fills are drawn into a band of rows, in vectors of single precision
// (interp/visibility/z_buffer.md).

/// The depths and fills of some rows of a picture. Rows lie `stride` apart and may be written up
/// to their stride.
struct BandRows {
  static constexpr int kMostRows = 16;
  static constexpr std::size_t kPadding = 16;  ///< columns beyond the picture's
  static constexpr int kTileColumns = 16;

  int row_begin, row_end;  ///< no more than kMostRows
  int width;
  std::size_t stride;
  float* z;                 ///< minus infinity: background; NaN: of a fill that is not certain
  ViewedScene::Fill* fill;  ///< ViewedScene::kBackground: none

  // Tiles are kTileColumns columns of all these rows.
  /// A depth beyond which no pixel of the tile lies, minus infinity if none is known. There is room
  /// for kPadding more.
  float* farthest;
  /// The single fill that a tile shows, written into its pixels later; the background, which is
  /// already there; or kSeveral.
  ViewedScene::Fill* whole;
  static constexpr ViewedScene::Fill kSeveral = ~ViewedScene::Fill{0};

  std::size_t tiles() const { return static_cast<std::size_t>((width - 1) / kTileColumns + 1); }
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row - row_begin) * stride + static_cast<std::size_t>(column);
  }
};

/// Working memory for drawing into bands, kept between bands and pictures.
struct BandScratch {
  struct Run {
    int first, end;
  };
  std::vector<std::uint32_t> open;  ///< where a fill may be visible: a bit a tile, a word a vector
  std::vector<float> own_farthest;  ///< its depths in these tiles
  std::vector<Run> runs;            ///< of columns, in which it is to be drawn
};

/// The depth of a fill minus that of one drawn before it, times a positive number: z + dz_dx i +
/// dz_dy j at column i of row j of the picture, about 1 where it is largest. The fill is visible
/// where it is positive.
struct DepthDifference {
  ViewedScene::Fill from = ViewedScene::kBackground;  ///< the one drawn before
  double z = 0.0, dz_dx = 0.0, dz_dy = 0.0;
  /// Bounds the error of its evaluation in single precision.
  float error = 0.0F;
};

/// Decides the cases that single precision leaves open, and sets how far apart two depths must be
/// to decide. The z-buffer's policy, exact or with a ROUNDOFF, is here and nowhere else.
class BandDecisions {
 public:
  using Fill = ViewedScene::Fill;
  struct Span {
    int row, first, end;
  };

  virtual ~BandDecisions() = default;
  /// Single-precision depths farther apart than this decide which of two certain fills is visible.
  virtual float margin() const = 0;
  /// True if a pixel's fill is never replaced by a farther one, so that a tile's farthest depth is
  /// a valid bound.
  virtual bool keep_the_nearest() const = 0;
  /// Begins a fill, which is drawn until the next call.
  virtual void begin(Fill fill) = 0;
  /// The spans in which the fill begun covers centres of these rows; valid until the next call.
  virtual std::span<const Span> spans(int row_begin, int row_end) = 0;
  /// The difference between the current fill and another, by their present data.
  virtual DepthDifference difference_from(Fill other) = 0;
  /// Draws the pixels of a row, from `column`, whose bits are set, one after another: the fill
  /// begun covers them, and each shows another fill. Returns true as soon as a new result about two
  /// fills is known, by which the remaining pixels may be decided.
  virtual bool draw(int row, int column, std::uint32_t bits) = 0;
};

/// The fills of a band, each half in order of entry.
struct FillsOfBand {
  std::span<const ViewedScene::Fill> towards;
  std::span<const ViewedScene::Fill> turned_away;  ///< RowFill::turned_away
};

/// Draws the fills into cleared rows. Those turned away come last, so that parts hidden by the
/// others in whole tiles are skipped. Uses the widest vectors of the processor; the visible fills
/// are the same with any.
void draw_into_band(const RowFills& fills, const FillsOfBand& to_draw, const BandRows& rows,
                    BandDecisions& decisions, BandScratch& scratch);

/// Draws as draw_into_band does, but with rounded decisions only, to measure the cost of exact
/// ones.
void draw_into_band_rounded(const RowFills& fills, const FillsOfBand& to_draw, const BandRows& rows,
                            BandDecisions& decisions, BandScratch& scratch);

}  // namespace displayfile
