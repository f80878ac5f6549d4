#include "interp/visibility/z_buffer_band.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

#include "clip/base/vector_kind.h"
#include "interp/scan/pixel_box.h"

// The code below is compiled once for each kind of vector.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "interp/visibility/z_buffer_band.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace displayfile::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::CappedTag<float, 16>;
using IntTag = hn::RebindToSigned<FloatTag>;
using FillTag = hn::RebindToUnsigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;
using FloatMask = hn::Mask<FloatTag>;

using Fill = ViewedScene::Fill;

/// The columns that a convex fill covers in each of some rows.
struct Columns {
  alignas(64) std::int32_t first[BandRows::kMostRows + 16];
  alignas(64) std::int32_t end[BandRows::kMostRows + 16];
};

template <bool kExact>
class RowDrawer {
 public:
  RowDrawer(const RowFills& fills, const BandRows& rows, BandDecisions& decisions,
            BandScratch& scratch)
      : fills_(fills),
        rows_(rows),
        decisions_(decisions),
        margin_(hn::Set(f_, kExact ? decisions.margin() : 0.0F)),
        keep_the_nearest_(decisions.keep_the_nearest()),
        open_(scratch.open),
        own_farthest_(scratch.own_farthest),
        runs_(scratch.runs) {}

  void draw(Fill fill) {
    const RowFill& f = fills_[fill];
    const int row_begin = std::max(f.row_begin, rows_.row_begin);
    const int row_end = std::min(f.row_end, rows_.row_end);
    if (row_begin >= row_end) return;
    if (f.turned_away && is_behind_all(f, {f.column, f.column_end, row_begin, row_end})) return;
    begun_ = false;
    forget_differences();
    const PixelBox& box = box_ = {f.column, f.column_end, row_begin, row_end};
    ordered_ = {};
    const bool by_tiles =
        f.certain && keep_the_nearest_ && is_wide(box.end_column - box.first_column);
    if (f.left != 0) {
      find_columns(f, fill, row_begin, row_end);
    } else if ((by_tiles && !find_open_tiles(f, box)) || !decide_all_columns(f, fill, box)) {
      return;
    }
    const int middle = (row_end - row_begin) / 2;
    if (by_tiles && is_wide(columns_.end[middle] - columns_.first[middle])) {
      if (f.left == 0 || find_open_tiles(f, box)) draw_open_tiles(f, fill, box);
      return;
    }
    write_wholes();
    for (int row = row_begin; row < row_end; ++row) {
      const int first = columns_.first[row - row_begin], end = columns_.end[row - row_begin];
      if (first < end) draw_span(f, fill, row, first, end);
    }
  }

  /// Finds the depth of the farthest pixel of each tile that has pixels of several fills.
  void find_farthest() {
    if (!keep_the_nearest_) return;
    farthest_found_ = true;
    const int lanes = static_cast<int>(hn::Lanes(f_));
    const Floats unknown = hn::Set(f_, -std::numeric_limits<float>::infinity());
    for (int tile = 0; tile < static_cast<int>(rows_.tiles()); ++tile) {
      const bool is_written = !wholes_known_ || rows_.whole[tile] == BandRows::kSeveral;
      if (!is_written || (tile + 1) * kTile > rows_.width) continue;
      Floats farthest = hn::Set(f_, std::numeric_limits<float>::infinity());
      for (int row = rows_.row_begin; row < rows_.row_end; ++row) {
        const float* const z = rows_.z + rows_.index(row, tile * kTile);
        for (int i = 0; i < kTile; i += lanes) {
          const Floats here = hn::LoadU(f_, z + i);
          farthest = hn::Min(farthest, hn::IfThenElse(hn::IsNaN(here), unknown, here));
        }
      }
      rows_.farthest[tile] =
          std::max(rows_.farthest[tile], hn::GetLane(hn::MinOfLanes(f_, farthest)));
    }
  }

  /// Writes the fills of all uniform tiles into their pixels; tiles are no longer tracked from here
  /// on.
  void write_wholes() {
    if (!wholes_known_) return;
    wholes_known_ = false;
    for (int tile = 0; tile < static_cast<int>(rows_.tiles()); ++tile) write_whole(tile);
  }

 private:
  void begin(Fill fill) {
    if (!begun_) decisions_.begin(fill);
    begun_ = true;
  }

  /// The crossing that bounds the polygon in a row, on its left or right: with the sides there
  /// extended to lines, the rightmost of the left crossings, the leftmost of the right ones.
  HWY_INLINE Floats crossing(const RowEdge* edges, int count, bool rightmost, Floats row) const {
    Floats x = hn::MulAdd(hn::Set(f_, edges[0].slope), row, hn::Set(f_, edges[0].x));
    for (int k = 1; k < count; ++k) {
      const Floats other = hn::MulAdd(hn::Set(f_, edges[k].slope), row, hn::Set(f_, edges[k].x));
      x = rightmost ? hn::Max(x, other) : hn::Min(x, other);
    }
    return x;
  }

  HWY_INLINE void find_columns(const RowFill& f, Fill fill, int row_begin, int row_end) {
    const RowEdge* const edges = fills_.edges_of(f);
    const Floats error = hn::Set(f_, f.edge_error);
    const Ints origin = hn::Set(i_, f.column), width = hn::Set(i_, rows_.width);
    const int lanes = static_cast<int>(hn::Lanes(f_));
    const auto column = [&](Floats crossing) {
      const Ints c = hn::Add(hn::ConvertTo(i_, hn::Ceil(crossing)), origin);
      return hn::Min(hn::Max(c, hn::Zero(i_)), width);
    };
    for (int row = row_begin; row < row_end; row += lanes) {
      const Floats at = hn::Iota(f_, static_cast<float>(row - f.row_begin));
      const Floats left = crossing(edges, f.left, true, at);
      const Floats right = crossing(edges + f.left, f.right, false, at);
      hn::StoreU(column(left), i_, columns_.first + (row - row_begin));
      hn::StoreU(column(right), i_, columns_.end + (row - row_begin));
      if constexpr (kExact) {
        // The distance from the middle between two centres; half a column at a centre.
        const Floats half = hn::Set(f_, 0.5F);
        const Floats off = hn::Max(hn::Abs(hn::Sub(hn::Sub(hn::Ceil(left), left), half)),
                                   hn::Abs(hn::Sub(hn::Sub(hn::Ceil(right), right), half)));
        const auto undecided = hn::And(hn::Ge(off, hn::Sub(half, error)),
                                       hn::FirstN(f_, static_cast<std::size_t>(row_end - row)));
        if (HWY_UNLIKELY(!hn::AllFalse(f_, undecided))) {
          decide_columns(fill, row, std::min(row + lanes, row_end), row_begin);
        }
      }
    }
  }

  static constexpr int kTile = BandRows::kTileColumns;

  /// True if the fill, in that box, lies behind everything that its tiles show. Depth is linear: it
  /// is nearest at a corner of the box.
  HWY_INLINE bool is_behind_all(const RowFill& f, const PixelBox& box) const {
    const int first_tile = box.first_column / kTile, last_tile = (box.end_column - 1) / kTile;
    if (!farthest_found_ || !f.certain || last_tile - first_tile > 1) return false;
    const int row = (f.dz_dy > 0.0F ? box.end_row - 1 : box.first_row) - f.row_begin;
    const int column = f.dz_dx > 0.0F ? box.end_column - 1 - f.column : 0;
    const float nearest =
        f.z + static_cast<float>(row) * f.dz_dy + static_cast<float>(column) * f.dz_dx;
    const float farthest = std::min(rows_.farthest[first_tile], rows_.farthest[last_tile]);
    return nearest - farthest < -hn::GetLane(margin_);
  }

  /// Examining tiles costs as much as drawing a few rows.
  static bool is_wide(int columns) { return columns >= 4 * kTile; }

  /// Finds the tiles, in runs, where the fill may be visible: in the others it lies behind
  /// everything drawn. Depth is linear, so over the covered part of a tile it is nearest and
  /// farthest at corners. False if there is none.
  HWY_NOINLINE bool find_open_tiles(const RowFill& f, const PixelBox& box) {
    const int low = box.first_row - f.row_begin, high = box.end_row - 1 - f.row_begin;
    const bool rises = f.dz_dx > 0.0F, climbs = f.dz_dy > 0.0F;
    const Floats near_row = hn::Set(f_, f.z + static_cast<float>(climbs ? high : low) * f.dz_dy);
    const Floats far_row = hn::Set(f_, f.z + static_cast<float>(climbs ? low : high) * f.dz_dy);
    const Floats slope = hn::Set(f_, f.dz_dx);
    const int lanes = static_cast<int>(hn::Lanes(f_));
    open_.clear();
    bool any = false;
    first_tile_ = box.first_column / kTile;
    const int end_tile = (box.end_column - 1) / kTile + 1;
    own_farthest_.resize(static_cast<std::size_t>(end_tile - first_tile_ + lanes));
    for (int tile = first_tile_; tile < end_tile; tile += lanes) {
      const Ints begin = hn::Mul(hn::Iota(i_, tile), hn::Set(i_, kTile));
      const Ints last = hn::Add(begin, hn::Set(i_, kTile - 1));
      const Ints left = hn::Max(begin, hn::Set(i_, box.first_column));
      const Ints right = hn::Min(last, hn::Set(i_, box.end_column - 1));
      const auto from_first = [&](Ints column) {
        return hn::ConvertTo(f_, hn::Sub(column, hn::Set(i_, f.column)));
      };
      const Floats nearest = hn::MulAdd(slope, from_first(rises ? right : left), near_row);
      hn::StoreU(hn::MulAdd(slope, from_first(rises ? left : right), far_row), f_,
                 own_farthest_.data() + (tile - first_tile_));
      const Floats known = hn::LoadU(f_, rows_.farthest + tile);
      const auto open = hn::AndNot(hn::Lt(hn::Sub(nearest, known), hn::Neg(margin_)),
                                   hn::FirstN(f_, static_cast<std::size_t>(end_tile - tile)));
      open_.push_back(bits_of(open));
      any |= open_.back() != 0;
    }
    return any;
  }

  /// The columns covered in every row.
  struct Common {
    int first, end;
  };
  HWY_INLINE Common common_columns(int rows) const {
    const int lanes = static_cast<int>(hn::Lanes(i_));
    Ints first = hn::Zero(i_), end = hn::Set(i_, std::numeric_limits<int>::max());
    for (int row = 0; row < rows; row += lanes) {
      const auto used = hn::FirstN(i_, static_cast<std::size_t>(rows - row));
      first = hn::Max(first, hn::IfThenElse(used, hn::LoadU(i_, columns_.first + row), first));
      end = hn::Min(end, hn::IfThenElse(used, hn::LoadU(i_, columns_.end + row), end));
    }
    return {hn::GetLane(hn::MaxOfLanes(i_, first)), hn::GetLane(hn::MinOfLanes(i_, end))};
  }

  /// A tile that the fill covers shows nothing beyond the fill's own farthest depth from now on. If
  /// it showed a single farther fill, or nothing, it now shows this one.
  void draw_open_tiles(const RowFill& f, Fill fill, const PixelBox& box) {
    const bool all_rows = box.first_row == rows_.row_begin && box.end_row == rows_.row_end;
    const Common common = all_rows ? common_columns(box.end_row - box.first_row) : Common{0, 0};
    const int lanes = static_cast<int>(hn::Lanes(f_));
    runs_.clear();
    for (std::size_t k = 0; k < open_.size(); ++k) {
      for (std::uint32_t open = open_[k]; open != 0; open &= open - 1) {
        const int tile = first_tile_ + static_cast<int>(k) * lanes + std::countr_zero(open);
        const int first = tile * kTile, end = std::min(first + kTile, rows_.width);
        const bool covered = common.first <= first && end <= common.end;
        if (covered) {
          rows_.farthest[tile] = std::max(
              rows_.farthest[tile], own_farthest_[static_cast<std::size_t>(tile - first_tile_)]);
        }
        if (wholes_known_) {
          const int order =
              order_in_tile(tile, fill,
                            {std::max(first, box.first_column), std::min(end, box.end_column),
                             box.first_row, box.end_row});
          if (order < 0) continue;
          if (order > 0 && covered) {
            rows_.whole[tile] = fill;
            continue;
          }
          write_whole(tile);
        }
        if (!runs_.empty() && runs_.back().end == first) {
          runs_.back().end = end;
        } else {
          runs_.push_back({first, end});
        }
      }
    }
    if (!runs_.empty()) draw_runs(f, fill, box);
  }

  void draw_runs(const RowFill& f, Fill fill, const PixelBox& box) {
    for (int row = box.first_row; row < box.end_row; ++row) {
      const int row_first = columns_.first[row - box.first_row];
      const int row_end = columns_.end[row - box.first_row];
      for (const BandScratch::Run& run : runs_) {
        const int first = std::max(row_first, run.first), end = std::min(row_end, run.end);
        if (first < end) draw_span(f, fill, row, first, end);
      }
    }
  }

  /// Compares the fill with the fill that the tile shows, over a part of it: as order_over.
  int order_in_tile(int tile, Fill fill, const PixelBox& part) {
    const Fill shown = rows_.whole[tile];
    if (shown == ViewedScene::kBackground) return 1;
    if (shown == BandRows::kSeveral) return 0;
    if (shown != ordered_.fill) {
      begin(fill);
      keep_order(difference_from(shown));
    }
    if (shown == ordered_.fill) return ordered_.is_behind ? 1 : -1;
    return order_over(close_, part);
  }

  /// 1 if the fill of the difference is visible all over the box, -1 if nowhere; 0 if unknown.
  static int order_over(const DepthDifference& d, const PixelBox& box) {
    const double at = d.z + d.dz_dx * box.first_column + d.dz_dy * box.first_row;
    const double along = d.dz_dx * (box.end_column - 1 - box.first_column);
    const double up = d.dz_dy * (box.end_row - 1 - box.first_row);
    const double error = d.error;
    if (at + std::min(along, 0.0) + std::min(up, 0.0) > error) return 1;
    return at + std::max(along, 0.0) + std::max(up, 0.0) < -error ? -1 : 0;
  }

  /// Writes the tile's fill into its pixels; from now on it shows several fills.
  void write_whole(int tile) {
    Fill& shown = rows_.whole[tile];
    if (shown != ViewedScene::kBackground && shown != BandRows::kSeveral) {
      const RowFill& f = fills_[shown];
      const int first = tile * kTile, end = std::min(first + kTile, rows_.width);
      for (int row = rows_.row_begin; row < rows_.row_end; ++row) {
        write_span(f, shown, row, first, end);
      }
    }
    shown = BandRows::kSeveral;
  }

  /// Finds the columns of a fill that is not known to be convex. If a row has several runs, they
  /// are drawn at once, and false is returned.
  HWY_NOINLINE bool decide_all_columns(const RowFill& f, Fill fill, const PixelBox& box) {
    begin(fill);
    const auto spans = decisions_.spans(box.first_row, box.end_row);
    const auto same_row = [](const auto& a, const auto& b) { return a.row == b.row; };
    if (std::ranges::adjacent_find(spans, same_row) == spans.end()) {
      take_columns(spans, box.first_row, box.end_row, box.first_row);
      return true;
    }
    write_wholes();
    for (const auto& span : spans) draw_span(f, fill, span.row, span.first, span.end);
    return false;
  }

  HWY_NOINLINE void decide_columns(Fill fill, int from, int to, int row_begin) {
    begin(fill);
    take_columns(decisions_.spans(from, to), from, to, row_begin);
  }

  void take_columns(std::span<const BandDecisions::Span> spans, int from, int to, int row_begin) {
    for (int row = from; row < to; ++row) {
      columns_.first[row - row_begin] = columns_.end[row - row_begin] = 0;
    }
    for (const auto& span : spans) {
      columns_.first[span.row - row_begin] = span.first;
      columns_.end[span.row - row_begin] = span.end;
    }
  }

  HWY_INLINE void draw_span(const RowFill& f, Fill fill, int row, int first, int end) {
    const int lanes = static_cast<int>(hn::Lanes(f_));
    const Floats slope = hn::Set(f_, f.dz_dx);
    const float start =
        f.certain ? start_of_span(f, row, first) : std::numeric_limits<float>::quiet_NaN();
    const auto own = hn::Set(u_, fill);
    Floats offset = hn::Iota(f_, 0.0F);
    const Floats step = hn::Set(f_, static_cast<float>(lanes));
    float* const z_row = rows_.z + rows_.index(row, 0);
    Fill* const fill_row = rows_.fill + rows_.index(row, 0);
    for (int i = first; i < end; i += lanes, offset = hn::Add(offset, step)) {
      const auto covered = hn::FirstN(f_, static_cast<std::size_t>(end - i));
      const Floats z = hn::MulAdd(slope, offset, hn::Set(f_, start));
      const Floats old = hn::LoadU(f_, z_row + i);
      const Floats nearer_by = hn::Sub(z, old);
      if constexpr (kExact) {
        const auto decided = hn::Gt(hn::Abs(nearer_by), margin_);
        auto nearer = hn::And(covered, hn::Gt(nearer_by, margin_));
        const auto undecided = hn::AndNot(decided, covered);
        if (HWY_UNLIKELY(!hn::AllFalse(f_, undecided))) {
          const auto shown = hn::LoadU(u_, fill_row + i);
          const auto same = hn::RebindMask(f_, hn::Eq(shown, hn::Set(u_, ordered_.fill)));
          if (!hn::AllFalse(f_, hn::AndNot(same, undecided))) {
            begin(fill);
            return draw_closely(fill, row, {first, i, end}, slope, start);
          }
          if (ordered_.is_behind) nearer = hn::Or(nearer, undecided);
        }
        store(nearer, z, old, own, z_row + i, fill_row + i);
      } else {
        store(hn::And(covered, hn::Ge(nearer_by, margin_)), z, old, own, z_row + i, fill_row + i);
      }
    }
  }

  /// Writes a span without comparing depths.
  HWY_INLINE void write_span(const RowFill& f, Fill fill, int row, int first, int end) {
    const int lanes = static_cast<int>(hn::Lanes(f_));
    const Floats slope = hn::Set(f_, f.dz_dx);
    const Floats start = hn::Set(f_, start_of_span(f, row, first));
    Floats offset = hn::Iota(f_, 0.0F);
    const Floats step = hn::Set(f_, static_cast<float>(lanes));
    float* const z_row = rows_.z + rows_.index(row, 0);
    Fill* const fill_row = rows_.fill + rows_.index(row, 0);
    for (int i = first; i < end; i += lanes, offset = hn::Add(offset, step)) {
      hn::StoreU(hn::MulAdd(slope, offset, start), f_, z_row + i);
      hn::StoreU(hn::Set(u_, fill), u_, fill_row + i);
    }
  }

  static float start_of_span(const RowFill& f, int row, int first) {
    return f.z + static_cast<float>(row - f.row_begin) * f.dz_dy +
           static_cast<float>(first - f.column) * f.dz_dx;
  }

  /// A span, and the column from which it is still to be drawn.
  struct SpanLeft {
    int first, from, end;
  };

  /// The difference of depths between the fill drawn and another, along a row.
  struct RowDifference {
    Fill from;
    Floats start, slope, error;  ///< start: at the first column of the span
  };
  HWY_INLINE RowDifference in_row(const DepthDifference& d, int row, int first) const {
    const double start = d.z + d.dz_dy * row + d.dz_dx * first;
    return {d.from, hn::Set(f_, static_cast<float>(start)),
            hn::Set(f_, static_cast<float>(d.dz_dx)), hn::Set(f_, d.error)};
  }

  /// Draws where depths are too close: a pixel that shows the last close fill is decided by the
  /// difference of the two depths, which is more accurate than either of them.
  HWY_NOINLINE void draw_closely(Fill fill, int row, const SpanLeft& span, Floats slope,
                                 float start) {
    const int lanes = static_cast<int>(hn::Lanes(f_));
    const auto own = hn::Set(u_, fill);
    const Floats step = hn::Set(f_, static_cast<float>(lanes));
    float* const z_row = rows_.z + rows_.index(row, 0);
    Fill* const fill_row = rows_.fill + rows_.index(row, 0);
    RowDifference close = in_row(close_, row, span.first);
    Floats offset = hn::Iota(f_, static_cast<float>(span.from - span.first));
    for (int i = span.from; i < span.end;) {
      const auto covered = hn::FirstN(f_, static_cast<std::size_t>(span.end - i));
      const Floats z = hn::MulAdd(slope, offset, hn::Set(f_, start));
      const Floats old = hn::LoadU(f_, z_row + i);
      const Floats nearer_by = hn::Sub(z, old);
      const auto shown = hn::LoadU(u_, fill_row + i);
      const auto shows = [&](Fill one) {
        return hn::RebindMask(f_, hn::Eq(shown, hn::Set(u_, one)));
      };
      const FloatMask others = hn::AndNot(shows(fill), covered);  // unless they are redone
      FloatMask nearer = hn::And(others, hn::Gt(nearer_by, margin_));
      FloatMask undecided = hn::AndNot(hn::Gt(hn::Abs(nearer_by), margin_), others);
      const auto decide_close = [&](FloatMask same) {
        const Floats by = hn::MulAdd(close.slope, offset, close.start);
        nearer = hn::Or(nearer, hn::And(same, hn::Gt(by, close.error)));
        return hn::AndNot(hn::Gt(hn::Abs(by), close.error), same);
      };
      FloatMask same = hn::And(undecided, shows(close.from));
      FloatMask too_close = decide_close(same);
      undecided = hn::AndNot(same, undecided);
      while (HWY_UNLIKELY(!hn::AllFalse(f_, undecided))) {
        const Fill other = fill_row[i + static_cast<int>(hn::FindKnownFirstTrue(f_, undecided))];
        close = in_row(difference_from(other), row, span.first);
        keep_order(close_);
        same = hn::And(undecided, shows(close.from));
        too_close = hn::Or(too_close, decide_close(same));
        undecided = hn::AndNot(same, undecided);
      }
      store(nearer, z, old, own, z_row + i, fill_row + i);
      if (HWY_UNLIKELY(!hn::AllFalse(f_, too_close)) && draw_exactly(row, i, too_close)) {
        forget_differences();
        close = in_row(close_, row, span.first);
        continue;  // redone with the new results
      }
      i += lanes;
      offset = hn::Add(offset, step);
    }
  }

  /// Remembers a fill that lies before or behind the one begun in all rows: neighbouring pixels and
  /// rows are then decided without evaluating the difference again.
  void keep_order(const DepthDifference& d) {
    const int order = order_over(d, box_);
    if (order != 0) ordered_ = {d.from, order > 0};
  }

  HWY_INLINE bool draw_exactly(int row, int column, FloatMask pixels) {
    return decisions_.draw(row, column, bits_of(pixels));
  }

  static HWY_INLINE std::uint32_t bits_of(FloatMask mask) {
    alignas(8) std::uint8_t bits[8] = {};
    hn::StoreMaskBits(f_, mask, bits);
    return static_cast<std::uint32_t>(bits[0] | bits[1] << 8);
  }

  void forget_differences() {
    ++generation_;
    close_ = {.from = ViewedScene::kBackground,
              .z = 1.0};  // a fill drawn over the background is visible
  }

  /// The difference from the other fill, which becomes the close one.
  const DepthDifference& difference_from(Fill other) {
    if (other == ViewedScene::kBackground) return close_ = {.from = other, .z = 1.0};
    Remembered& known = differences_[other % differences_.size()];
    if (known.generation != generation_ || known.difference.from != other) {
      known = {decisions_.difference_from(other), generation_};
    }
    return close_ = known.difference;
  }

  template <class Mask, class Own>
  HWY_INLINE void store(Mask mask, Floats z, Floats old, Own own, float* z_at, Fill* fill_at) {
    hn::StoreU(hn::IfThenElse(mask, z, old), f_, z_at);
    const auto old_fill = hn::LoadU(u_, fill_at);
    hn::StoreU(hn::IfThenElse(hn::RebindMask(u_, mask), own, old_fill), u_, fill_at);
  }

  static constexpr FloatTag f_{};
  static constexpr IntTag i_{};
  static constexpr FillTag u_{};
  const RowFills& fills_;
  const BandRows& rows_;
  BandDecisions& decisions_;
  Floats margin_;
  bool keep_the_nearest_;
  Columns columns_;
  // The tiles of the fill begun.
  int first_tile_ = 0;
  std::vector<std::uint32_t>& open_;
  std::vector<float>& own_farthest_;
  std::vector<BandScratch::Run>& runs_;
  bool wholes_known_ = true;  // BandRows::whole is kept
  bool farthest_found_ = false;
  bool begun_ = false;
  PixelBox box_{};  // that holds all that is drawn of the fill begun
  /// Differences from fills drawn before the one begun, by their numbers.
  struct Remembered {
    DepthDifference difference;
    std::uint64_t generation = 0;  // others are forgotten
  };
  std::array<Remembered, 16> differences_;
  std::uint64_t generation_ = 0;
  DepthDifference close_;  // that which was used last
  /// A fill that lies before or behind the fill begun wherever that is drawn.
  struct Ordered {
    Fill fill = BandRows::kSeveral;
    bool is_behind = false;
  };
  Ordered ordered_;
};

template <bool kExact>
void draw_each(const RowFills& fills, std::span<const Fill> to_draw, RowDrawer<kExact>& drawer) {
  constexpr std::size_t kAhead = 8;  // fills lie far apart
  for (std::size_t k = 0; k < to_draw.size(); ++k) {
    if (k + kAhead < to_draw.size()) {
      __builtin_prefetch(&fills[to_draw[k + kAhead]]);
    }
    drawer.draw(to_draw[k]);
  }
}

template <bool kExact>
void draw_all(const RowFills& fills, const FillsOfBand& to_draw, const BandRows& rows,
              BandDecisions& decisions, BandScratch& scratch) {
  RowDrawer<kExact> drawer(fills, rows, decisions, scratch);
  draw_each(fills, to_draw.towards, drawer);
  if (!to_draw.towards.empty() && !to_draw.turned_away.empty()) drawer.find_farthest();
  draw_each(fills, to_draw.turned_away, drawer);
  drawer.write_wholes();
}

void DrawExact(const RowFills& fills, const FillsOfBand& to_draw, const BandRows& rows,
               BandDecisions& decisions, BandScratch& scratch) {
  draw_all<true>(fills, to_draw, rows, decisions, scratch);
}
void DrawRounded(const RowFills& fills, const FillsOfBand& to_draw, const BandRows& rows,
                 BandDecisions& decisions, BandScratch& scratch) {
  draw_all<false>(fills, to_draw, rows, decisions, scratch);
}

}  // namespace displayfile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace displayfile {

void draw_into_band(const RowFills& fills, const FillsOfBand& to_draw, const BandRows& rows,
                    BandDecisions& decisions, BandScratch& scratch) {
  DISPLAYFILE_WIDEST_FORM(DrawExact)(fills, to_draw, rows, decisions, scratch);
}

void draw_into_band_rounded(const RowFills& fills, const FillsOfBand& to_draw, const BandRows& rows,
                            BandDecisions& decisions, BandScratch& scratch) {
  DISPLAYFILE_WIDEST_FORM(DrawRounded)(fills, to_draw, rows, decisions, scratch);
}

}  // namespace displayfile
#endif
