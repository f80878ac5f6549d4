#include "interp/visibility/z_buffer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>

#include "clip/base/parallel.h"
#include "interp/scan/boundary_centres.h"
#include "interp/scan/scan_convert.h"
#include "interp/visibility/fill_depths.h"
#include "interp/visibility/fills_as_entered.h"
#include "interp/visibility/pair_orders.h"
#include "interp/visibility/z_buffer_band.h"

namespace displayfile {

namespace {

using Fill = ViewedScene::Fill;

/// Depths in doubles of recently used fills.
class KnownDepths {
 public:
  KnownDepths(const ViewedScene& scene, const PictureSize& size) : scene_(&scene), size_(size) {
    known_.reserve(kMost);
  }
  void take(const ViewedScene& scene, const PictureSize& size) {
    scene_ = &scene;
    size_ = size;
    known_.clear();
  }
  const FillDepth& of(Fill fill) {
    if (known_.empty()) known_.resize(std::bit_ceil(std::min<std::size_t>(scene_->end(), kMost)));
    Known& known = known_[fill & (known_.size() - 1)];
    if (known.fill != fill) known = {fill, FillDepth(*scene_, fill, size_, std::nullopt)};
    return known.depth;
  }

 private:
  static constexpr std::size_t kMost = 256;
  struct Known {
    Fill fill = ViewedScene::kBackground;
    FillDepth depth;
  };
  const ViewedScene* scene_;
  PictureSize size_;
  std::vector<Known> known_;
};

/// Decides first in doubles, and then by exact arithmetic; or as the textbook's SIGNOF does: closer
/// than ROUNDOFF counts as equal, and of equals the later is visible.
class DepthDecisions : public BandDecisions {
 public:
  DepthDecisions(const ImageSpaceMethod::Request& request, const RowFills& fills,
                 const BandRows& rows)
      : fills_(fills), rows_(rows), known_(request.scene, request.size), orders_(request.scene) {
    take(request);
  }
  /// Prepares for the pictures of another request, reusing memory.
  void take(const ImageSpaceMethod::Request& request) {
    scene_ = &request.scene;
    size_ = request.size;
    roundoff_ = request.roundoff;
    fill_ = own_fill_ = ViewedScene::kBackground;
    notes_ = decides_as_entered(request);
    known_.take(request.scene, request.size);
    orders_.take(request.scene);
  }

  float margin() const override {
    const double margin = 2.0 * static_cast<double>(fills_.depth_error()) + roundoff_.value_or(0.0);
    return static_cast<float>(margin) * (1.0F + 0x1p-20F);
  }

  /// With a ROUNDOFF, a replacing fill may be farther by less than it, and after several
  /// replacements much farther.
  bool keep_the_nearest() const override { return !roundoff_; }

  void begin(Fill fill) override { fill_ = fill; }

  std::span<const Span> spans(int row_begin, int row_end) override {
    spans_.clear();
    const auto take = [&](int row, int first, int end) { spans_.push_back({row, first, end}); };
    const PointRow vertices = scene_->vertices(fill_);
    const std::span<const Point3> polygon{vertices.data(), vertices.size()};
    const ScanConverter::Region region{size_, row_begin, row_end};
    if (!notes_) {
      converter_.scan_convert(polygon, region, take);
    } else {
      note_and_scan(polygon, region, take);
    }
    return spans_;
  }

  /// Begins a band, without noted centres.
  void begin_band() { noted_ = PixelSet(size_.width, rows_.row_begin, rows_.row_end); }
  /// Decides the noted centres, close to boundaries of the band's fills, as entered.
  void decide_noted(const FillsOfBand& fills) {
    if (noted_.empty()) return;
    in_order_.resize(fills.towards.size() + fills.turned_away.size());
    std::ranges::merge(fills.towards, fills.turned_away, in_order_.begin());
    FillsAsEntered(*scene_, size_).decide(noted_, in_order_, [&](int row, int column, Fill fill) {
      rows_.fill[rows_.index(row, column)] = fill;
    });
  }
  static bool decides_as_entered(const ImageSpaceMethod::Request& request) {
    return !request.roundoff && request.scene.viewing_radius() > 0.0;
  }

  DepthDifference difference_from(Fill other) override {
    if (roundoff_) return rounded_difference(other);
    const auto [earlier, later] = std::minmax(other, fill_);
    const PairOrders::Known known = orders_.known(earlier, later);
    if (known.order != Order::varies) return everywhere(other, known.order);
    if (known.earlier_less_later) return exact_difference(other, *known.earlier_less_later);
    const DepthDifference difference = rounded_difference(other);
    if (difference.error < kNothingKnown) return difference;
    const Order order = orders_.order_if_often(earlier, later);
    return order == Order::varies ? difference : everywhere(other, order);
  }

  bool draw(int row, int column, std::uint32_t bits) override {
    const FillDepth& own = own_depth();
    const double own_row = own.depth.row(row);
    for (; bits != 0; bits &= bits - 1) {
      const int i = column + std::countr_zero(bits);
      const std::size_t at = rows_.index(row, i);
      const double z = own.depth.at(own_row, i);
      const std::size_t learnt = orders_.times_learnt();
      if (is_seen(row, i, z, rows_.fill[at])) {
        rows_.fill[at] = fill_;
        rows_.z[at] = fills_[fill_].at(row, i);
      }
      if (orders_.times_learnt() != learnt) return true;
    }
    return false;
  }

 private:
  using Order = PairOrders::Order;

  template <class Take>
  void note_and_scan(std::span<const Point3> polygon, const ScanConverter::Region& region,
                     Take&& take) {
    const Point2 error = boundary_error(*scene_, polygon, size_);
    note_rows_of_vertices(polygon, error, size_, noted_);
    const auto rows = converter_.begin(polygon, region);
    if (rows.first == rows.end) return;
    converter_.watch(error);
    converter_.scan(take, [&](int row, int first, int end) { noted_.add(row, first, end); });
  }

  /// A difference in single precision is 1 at most.
  static constexpr float kNothingKnown = 1.0F;

  /// The difference for a pair of which one fill is visible wherever both cover.
  DepthDifference everywhere(Fill other, Order order) const {
    const bool later_is_seen = order == Order::second;
    return {.from = other, .z = later_is_seen == is_later(other) ? 1.0 : -1.0};
  }

  /// True if the fill begun was entered after the other, which was drawn before it.
  bool is_later(Fill other) const { return fill_ > other; }

  const FillDepth& own_depth() {
    if (own_fill_ != fill_) {
      own_fill_ = fill_;
      own_ = known_.of(fill_);
    }
    return own_;
  }

  /// True if the fill begun, of depth z at the pixel, is visible rather than the fill that the
  /// pixel shows.
  bool is_seen(int row, int column, double z, Fill other) {
    const FillDepth& other_depth = known_.of(other);
    const double nearer = z - finite(other_depth.depth.at(other_depth.depth.row(row), column));
    if (roundoff_) return !(nearer < -*roundoff_);
    const int order = rounded_order(nearer, own_.error + other_depth.error);
    if (order != 0) return order > 0;
    const auto [earlier, later] = std::minmax(other, fill_);
    const PixelCentre centre(column, row, size_);
    return orders_.later_is_seen(earlier, later, centre) == is_later(other);
  }

  /// A depth as stored by a z-buffer, in which infinity is the background.
  static double finite(double z) {
    constexpr double kLargest = std::numeric_limits<double>::max();
    return std::clamp(z, -kLargest, kLargest);
  }

  /// A difference with an error of at most `error`, and of magnitude at most `largest` on the
  /// picture, scaled for single precision.
  static DepthDifference in_single_precision(const DepthDifference& d, double largest,
                                             double error) {
    constexpr double kSingle = 0x1p-20, kLeast = 0x1p-900;
    const double scale = 1.0 / largest;
    const double bound = error * scale + kSingle;
    if (!(largest > kLeast && scale > kLeast && bound < 1.0)) {
      return {.from = d.from, .error = kNothingKnown};
    }
    return {d.from, d.z * scale, d.dz_dx * scale, d.dz_dy * scale, static_cast<float>(bound)};
  }

  DepthDifference exact_difference(Fill other, const DepthComparison::Linear& earlier_less_later) {
    const double sign = is_later(other) ? -1.0 : 1.0;
    const double dz_dx = sign * earlier_less_later.slope_x / size_.width;
    const double dz_dy = sign * earlier_less_later.slope_y / size_.height;
    const double z = 0.5 * (dz_dx + dz_dy) + sign * earlier_less_later.constant;
    return in_single_precision({.from = other, .z = z, .dz_dx = dz_dx, .dz_dy = dz_dy}, 4.0, 0.0);
  }

  DepthDifference rounded_difference(Fill other) {
    const FillDepth &own = own_depth(), &from = known_.of(other);
    const PixelDepth &a = own.depth, &b = from.depth;
    const double width = size_.width, height = size_.height;
    const auto largest = [&](const PixelDepth& d) {  // the largest intermediate value
      return std::abs(d.z0) + std::abs(d.dz_dx) * (std::abs(d.x0) + width) +
             std::abs(d.dz_dy) * (std::abs(d.y0) + height);
    };
    const double z = a.at(a.row(0), 0) - b.at(b.row(0), 0) + roundoff_.value_or(0.0);
    const double dz_dx = a.dz_dx - b.dz_dx, dz_dy = a.dz_dy - b.dz_dy;
    const double error = own.error + from.error + 8.0 * kUnit * (largest(a) + largest(b));
    return in_single_precision({.from = other, .z = z, .dz_dx = dz_dx, .dz_dy = dz_dy},
                               std::abs(z) + width * std::abs(dz_dx) + height * std::abs(dz_dy),
                               error);
  }

  const ViewedScene* scene_;
  PictureSize size_;
  std::optional<double> roundoff_;
  const RowFills& fills_;
  const BandRows& rows_;
  Fill fill_ = ViewedScene::kBackground;
  KnownDepths known_;
  Fill own_fill_ = ViewedScene::kBackground;
  FillDepth own_;
  PairOrders orders_;
  ScanConverter converter_;
  std::vector<Span> spans_;
  bool notes_ = false;  // centres where viewing may decide
  PixelSet noted_{0, 0, 0};
  std::vector<Fill> in_order_;
};

}  // namespace

/// A thread's working data for drawing bands.
struct ZBuffer::Worker {
  BandRows rows{};
  std::vector<float> z, farthest;
  std::vector<Fill> fill, whole, background;
  BandScratch scratch;
  std::optional<DepthDecisions> decisions;

  void take(const Request& request, const RowFills& fills) {
    const int width = request.size.width;
    const std::size_t stride = static_cast<std::size_t>(width) + BandRows::kPadding;
    z.resize(stride * kRowsOfABand);
    fill.resize(stride * kRowsOfABand);
    rows = {0, 0, width, stride, z.data(), fill.data(), nullptr, nullptr};
    farthest.resize(rows.tiles() + BandRows::kPadding);
    whole.resize(rows.tiles());
    rows.farthest = farthest.data();
    rows.whole = whole.data();
    background.assign(static_cast<std::size_t>(width), ViewedScene::kBackground);
    decisions ? decisions->take(request) : (void)decisions.emplace(request, fills, rows);
  }
  /// Begins a band that has fills in those columns.
  void begin(int row_begin, int row_end, int first, int end) {
    rows.row_begin = row_begin;
    rows.row_end = row_end;
    const std::size_t columns = static_cast<std::size_t>(end - first) + BandRows::kPadding;
    for (int row = row_begin; row < row_end && first < end; ++row) {
      const std::size_t at = rows.index(row, first);
      std::fill_n(z.data() + at, columns, -std::numeric_limits<float>::infinity());
      std::fill_n(fill.data() + at, columns, ViewedScene::kBackground);
    }
    std::ranges::fill(farthest, -std::numeric_limits<float>::infinity());
    std::ranges::fill(whole, ViewedScene::kBackground);
  }
};

/// The idle workers.
struct ZBuffer::Workers {
  std::mutex mutex;
  std::vector<std::unique_ptr<Worker>> at_rest;
};

ZBuffer::ZBuffer(Decided decided) : decided_(decided), workers_(std::make_unique<Workers>()) {}
ZBuffer::~ZBuffer() = default;

void ZBuffer::prepare(const Request& request, int threads) {
  request_.emplace(request);
  bands_of_batches_.resize(bands() * RowFills::batches_of(request.scene));
  fills_.make(request.scene, request.size, threads, DepthDecisions::decides_as_entered(request),
              [&](const RowFills::Batch& batch) { count_in_bands(batch); });
  sort_into_bands(threads);
  for (const auto& worker : workers_->at_rest) worker->take(request, fills_);
}

std::unique_ptr<ZBuffer::Worker> ZBuffer::take_worker() const {
  {
    const std::lock_guard lock(workers_->mutex);
    if (!workers_->at_rest.empty()) {
      auto worker = std::move(workers_->at_rest.back());
      workers_->at_rest.pop_back();
      return worker;
    }
  }
  auto worker = std::make_unique<Worker>();
  worker->take(*request_, fills_);
  return worker;
}

void ZBuffer::give_back(std::unique_ptr<Worker> worker) const {
  const std::lock_guard lock(workers_->mutex);
  workers_->at_rest.push_back(std::move(worker));
}

template <class Visit>
void ZBuffer::for_each_band(const RowFill& fill, std::span<Band> bands, Visit&& visit) {
  if (fill.row_begin >= fill.row_end) return;
  const int last = (fill.row_end - 1) / kRowsOfABand;
  for (int band = fill.row_begin / kRowsOfABand; band <= last; ++band) {
    visit(bands[static_cast<std::size_t>(band)]);
  }
}

/// Counts a batch's fills in each band, and finds their columns.
void ZBuffer::count_in_bands(const RowFills::Batch& batch) {
  const std::span<Band> bands = of_batch(batch.number);
  std::ranges::fill(bands, Band{.first_column = request_->size.width});
  for (Fill k = batch.begin; k < batch.end; ++k) {
    const RowFill& fill = fills_[k];
    for_each_band(fill, bands, [&](Band& band) {
      ++(is_drawn_late(fill) ? band.end : band.turned_away);
      band.first_column = std::min(band.first_column, fill.column);
      band.end_column = std::max(band.end_column, fill.column_end);
    });
  }
}

/// A counting sort, the batches in parallel: each half of a band keeps the order of entry.
void ZBuffer::sort_into_bands(int threads) {
  bands_.assign(bands(), {.first_column = request_->size.width});
  std::uint32_t all = 0;
  const auto place = [&](std::uint32_t& count) { all += std::exchange(count, all); };
  for (std::size_t k = 0; k < bands_.size(); ++k) {
    Band& band = bands_[k];
    band.begin = all;
    for (std::size_t batch = 0; batch < fills_.batches(); ++batch) {
      Band& part = of_batch(batch)[k];
      place(part.turned_away);
      band.first_column = std::min(band.first_column, part.first_column);
      band.end_column = std::max(band.end_column, part.end_column);
    }
    band.turned_away = all;
    for (std::size_t batch = 0; batch < fills_.batches(); ++batch) place(of_batch(batch)[k].end);
    band.end = all;
  }
  const std::size_t in_other_views = std::max<std::size_t>(all, request_->scene.most_fills());
  if (all > in_bands_.capacity()) in_bands_.reserve(in_other_views + in_other_views / 2);
  in_bands_.resize(all);
  in_parallel(threads, fills_.batches(), [&](std::size_t batch) {
    const std::span<Band> places = of_batch(batch);
    const auto [number, begin, end] = fills_.batch(batch);
    for (Fill k = begin; k < end; ++k) {
      const bool late = is_drawn_late(fills_[k]);
      for_each_band(fills_[k], places,
                    [&](Band& band) { in_bands_[late ? band.end++ : band.turned_away++] = k; });
    }
  });
}

/// Outside of the columns of a band's fills the background is visible.
void ZBuffer::draw_rows(int row_begin, int row_end, const SeenRun& seen) const {
  auto worker = take_worker();
  const int width = request_->size.width;
  const auto draw = decided_ == Decided::truly ? draw_into_band : draw_into_band_rounded;
  const int last_band = (row_end - 1) / kRowsOfABand;
  for (int k = row_begin / kRowsOfABand; k <= last_band; ++k) {
    const Band& band = bands_[static_cast<std::size_t>(k)];
    constexpr int kTile = BandRows::kTileColumns;
    const int end = std::min(width, (band.end_column + kTile - 1) / kTile * kTile);
    const int first = std::min(band.first_column / kTile * kTile, end);
    const BandRows& rows = worker->rows;
    worker->begin(std::max(row_begin, k * kRowsOfABand), std::min(row_end, (k + 1) * kRowsOfABand),
                  first, end);
    worker->decisions->begin_band();
    draw(fills_, of_band(band), rows, *worker->decisions, worker->scratch);
    worker->decisions->decide_noted(of_band(band));
    const auto tell = [&](int row, int from, int to, const Fill* shown) {
      if (from < to) seen(row, from, {shown, static_cast<std::size_t>(to - from)});
    };
    for (int row = rows.row_begin; row < rows.row_end; ++row) {
      tell(row, 0, first, worker->background.data());
      tell(row, first, end, rows.fill + rows.index(row, first));
      tell(row, end, width, worker->background.data());
    }
  }
  give_back(std::move(worker));
}

}  // namespace displayfile
