#include "interp/band_z_buffer.h"

#include <algorithm>
#include <array>
#include <bit>
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
    for (; bits != 0; bits &= bits - 1) {
      const int i = column + std::countr_zero(bits);
      if (i < drawn) continue;
      const DecidedRun run = decided(row, i, end, rows_.fill + start);
      drawn = run.end;
      const auto seen = run.seen_from(i);
      std::fill(rows_.fill + start + seen.first, rows_.fill + start + seen.end, fill_);
      store_depths(row, seen.first, seen.end);
    }
    return drawn;
  }

 private:
  void store_depths(int row, int first, int end) {
    float* const z = rows_.z + rows_.index(row, 0);
    if (!fills_[fill_].certain) {
      std::fill(z + first, z + end, std::numeric_limits<float>::quiet_NaN());
      return;
    }
    const PixelDepth depth = own_.depth;
    const double row_depth = depth.row(row);
    for (int i = first; i < end; ++i) z[i] = static_cast<float>(depth.at(row_depth, i));
  }

  /// Pixels from there on that show the same fill, as many as are decided together.
  DecidedRun decided(int row, int column, int end, const Fill* fills) {
    const Fill other = fills[column];
    if (other == FillScene::kBackground) return {column + 1, column + 1, true};
    if (met_ != other) {
      met_ = other;
      times_met_ = 0;
      order_ = Order::varies;
    }
    // Two that are close in some runs often are in all.
    if (++times_met_ == kOftenMet) order_ = orders_.order_of(other, fill_);
    const int end_of_other = end_of_run(column, end, fills);
    if (order_ != Order::varies) return {end_of_other, end_of_other, order_ == Order::second};
    const FillDepth& other_depth = known_.of(other);
    const double own_row = own_.depth.row(row), other_row = other_depth.depth.row(row);
    const auto nearer = [&](int i) {
      return own_.depth.at(own_row, i) - other_depth.depth.at(other_row, i);
    };
    const double errors = own_.error + other_depth.error;
    const double slope = own_.depth.dz_dx - other_depth.depth.dz_dx;
    return run_of(column, end_of_other, meeting(column, nearer(column), slope), [&](int i) {
      const int order = rounded_order(nearer(i), errors);
      return order != 0 ? order > 0
                        : orders_.later_is_seen(other, fill_, PixelCentre(i, row, size_));
    });
  }

  /// About the column beyond which a difference that grows by `slope` a column is on the other side
  /// of zero.
  static int meeting(int column, double difference, double slope) {
    constexpr double kFar = 1 << 20;
    const double columns = -difference / slope;
    return column + static_cast<int>(columns < kFar ? std::max(columns, 0.0) : kFar);
  }

  static int end_of_run(int column, int end, const Fill* fills) {
    const Fill shown = fills[column];
    int same = column + 1;
    while (same < end && fills[same] == shown) ++same;
    return same;
  }

  using Order = PairOrders::Order;
  static constexpr int kOftenMet = 8;

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
