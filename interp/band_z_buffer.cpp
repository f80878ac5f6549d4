#include "interp/band_z_buffer.h"

#include <algorithm>
#include <array>
#include <limits>

#include "interp/decided_run.h"
#include "interp/fill_depths.h"
#include "interp/pair_orders.h"
#include "interp/scan_convert.h"
#include "interp/z_buffer_rows.h"

namespace displayfile {

namespace {

using Fill = FillScene::Fill;

/// Depths in doubles of fills that were asked for lately.
class KnownDepths {
 public:
  KnownDepths(const FillScene& scene, const PictureSize& size) : scene_(scene), size_(size) {}
  const FillDepth& of(Fill fill) {
    Known& known = known_[fill % kMost];
    if (known.fill != fill) known = {fill, FillDepth(scene_, fill, size_, std::nullopt)};
    return known.depth;
  }

 private:
  static constexpr std::size_t kMost = 32;
  struct Known {
    Fill fill = FillScene::kBackground;
    FillDepth depth;
  };
  const FillScene& scene_;
  PictureSize size_;
  std::array<Known, kMost> known_;
};

double depth_at(const FillDepth& depth, int row, int column) {
  return depth.depth.at(depth.depth.row(row), column);
}

/// First in doubles, then by exact arithmetic.
class ExactDecisions : public ExactRows {
 public:
  ExactDecisions(const FillScene& scene, const PictureSize& size, const RowFills& fills,
                 const DepthRows& rows)
      : scene_(scene),
        size_(size),
        fills_(fills),
        rows_(rows),
        known_(scene, size),
        orders_(scene) {}

  void begin(Fill fill) override { fill_ = fill; }

  std::span<const Span> spans(int row_begin, int row_end) override {
    spans_.clear();
    converter_.scan_convert(scene_.vertices(fill_), {size_, row_begin, row_end},
                            [&](int row, int first, int end) {
                              spans_.push_back({row, first, end});
                            });
    return spans_;
  }

  int draw(int row, int column, std::uint32_t bits, int end) override {
    if (own_fill_ != fill_) {
      own_fill_ = fill_;
      own_ = known_.of(fill_);
      met_ = FillScene::kBackground;
    }
    const std::size_t start = rows_.index(row, 0);
    int drawn = column;
    for (int i = column; bits != 0; ++i, bits >>= 1) {
      if ((bits & 1) == 0 || i < drawn) continue;
      const DecidedRun run = decided(row, i, end, rows_.fill + start);
      drawn = run.end;
      if (!run.later_is_seen) continue;
      for (int k = i; k < run.end; ++k) {
        const std::size_t at = start + static_cast<std::size_t>(k);
        rows_.fill[at] = fill_;
        rows_.z[at] = rounded_depth(row, k);
      }
    }
    return drawn;
  }

 private:
  float rounded_depth(int row, int column) const {
    const RowFill& f = fills_[fill_];
    if (!f.certain) return std::numeric_limits<float>::quiet_NaN();
    return static_cast<float>(depth_at(own_, row, column));
  }

  /// Pixels from there on that show the same fill, as many as are decided together.
  DecidedRun decided(int row, int column, int end, const Fill* fills) {
    const Fill other = fills[column];
    if (other == FillScene::kBackground) return {column + 1, true};
    if (met_ != other) {
      met_ = other;
      times_met_ = 0;
      order_ = Order::varies;
    }
    // Two that are close in some runs often are in all.
    if (++times_met_ == kOftenMet) order_ = orders_.order_of(other, fill_);
    const int end_of_other = end_of_run(column, end, fills);
    if (order_ != Order::varies) return {end_of_other, order_ == Order::second};
    const FillDepth& other_depth = known_.of(other);
    return run_of(column, end_of_other, [&](int i) {
      const int order = rounded_order(depth_at(own_, row, i) - depth_at(other_depth, row, i),
                                      own_.error + other_depth.error);
      return order != 0 ? order > 0
                        : orders_.later_is_seen(other, fill_, PixelCentre(i, row, size_));
    });
  }

  static int end_of_run(int column, int end, const Fill* fills) {
    int same = column + 1;
    while (same < end && fills[same] == fills[column]) ++same;
    return same;
  }

  using Order = PairOrders::Order;
  static constexpr int kOftenMet = 3;

  const FillScene& scene_;
  PictureSize size_;
  const RowFills& fills_;
  const DepthRows& rows_;
  Fill fill_ = FillScene::kBackground;
  KnownDepths known_;
  Fill own_fill_ = FillScene::kBackground;
  FillDepth own_;
  PairOrders orders_;
  Fill met_ = FillScene::kBackground;  // what was last compared with, how often in turn,
  int times_met_ = 0;
  Order order_ = Order::varies;  // and what is known of it
  ScanConverter converter_;
  std::vector<Span> spans_;
};

}  // namespace

void BandZBuffer::prepare(const Request& request, int threads) {
  request_.emplace(request);
  if (request.roundoff) return with_roundoff_.prepare(request, threads);
  fills_ = RowFills(request.scene, request.size, threads);
  sort_into_bands();
}

/// A counting sort: within a band the order of entry stays.
void BandZBuffer::sort_into_bands() {
  const auto bands = static_cast<std::size_t>((request_->size.height - 1) / kRowsOfABand + 1);
  const auto for_each_band = [&](Fill fill, auto&& visit) {
    const RowFill& f = fills_[fill];
    if (f.row_begin >= f.row_end) return;
    const int last = (f.row_end - 1) / kRowsOfABand;
    for (int band = f.row_begin / kRowsOfABand; band <= last; ++band) {
      visit(static_cast<std::size_t>(band));
    }
  };
  band_begin_.assign(bands + 1, 0);
  for (Fill fill = 1; fill < fills_.end(); ++fill) {
    for_each_band(fill, [&](std::size_t band) { ++band_begin_[band + 1]; });
  }
  for (std::size_t band = 0; band < bands; ++band) band_begin_[band + 1] += band_begin_[band];
  in_bands_.resize(band_begin_[bands]);
  std::vector<std::uint32_t> next(band_begin_.begin(), band_begin_.end() - 1);
  for (Fill fill = 1; fill < fills_.end(); ++fill) {
    for_each_band(fill, [&](std::size_t band) { in_bands_[next[band]++] = fill; });
  }
}

void BandZBuffer::draw_rows(int row_begin, int row_end, const SeenRun& seen) const {
  if (request_->roundoff) return with_roundoff_.draw_rows(row_begin, row_end, seen);
  const auto width = static_cast<std::size_t>(request_->size.width);
  const std::size_t stride = width + DepthRows::kPadding;
  std::vector<float> z(stride * kRowsOfABand);
  std::vector<Fill> fill(stride * kRowsOfABand);
  DepthRows rows{0, 0, request_->size.width, stride, z.data(), fill.data()};
  ExactDecisions exact(request_->scene, request_->size, fills_, rows);
  const int last_band = (row_end - 1) / kRowsOfABand;
  for (int band = row_begin / kRowsOfABand; band <= last_band; ++band) {
    rows.row_begin = std::max(row_begin, band * kRowsOfABand);
    rows.row_end = std::min(row_end, (band + 1) * kRowsOfABand);
    std::fill(z.begin(), z.end(), -std::numeric_limits<float>::infinity());
    std::fill(fill.begin(), fill.end(), FillScene::kBackground);
    const auto draw = decisions_ == Decisions::exact ? draw_into_rows : draw_into_rows_rounded;
    draw(fills_, of_band(static_cast<std::size_t>(band)), rows, exact);
    for (int row = rows.row_begin; row < rows.row_end; ++row) {
      seen(row, 0, {fill.data() + rows.index(row, 0), width});
    }
  }
}

}  // namespace displayfile
