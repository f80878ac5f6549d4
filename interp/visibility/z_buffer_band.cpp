#include "interp/visibility/z_buffer_band.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

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

using Fill = FillScene::Fill;

/// The columns that a convex fill covers in each of some rows.
struct Columns {
  alignas(64) std::int32_t first[BandRows::kMostRows + 16];
  alignas(64) std::int32_t end[BandRows::kMostRows + 16];
};

template <bool kExact>
class RowDrawer {
 public:
  RowDrawer(const RowFills& fills, const BandRows& rows, BandDecisions& decisions)
      : fills_(fills),
        rows_(rows),
        decisions_(decisions),
        margin_(hn::Set(f_, kExact ? decisions.margin() : 0.0F)) {}

  void draw(Fill fill) {
    const RowFill& f = fills_[fill];
    const int row_begin = std::max(f.row_begin, rows_.row_begin);
    const int row_end = std::min(f.row_end, rows_.row_end);
    if (row_begin >= row_end) return;
    begun_ = false;
    forget_differences();
    if (f.left == 0) {
      begin(fill);
      for (const auto& span : decisions_.spans(row_begin, row_end)) {
        draw_span(f, fill, span.row, span.first, span.end);
      }
      return;
    }
    find_columns(f, fill, row_begin, row_end);
    for (int row = row_begin; row < row_end; ++row) {
      const int first = columns_.first[row - row_begin], end = columns_.end[row - row_begin];
      if (first < end) draw_span(f, fill, row, first, end);
    }
  }

 private:
  void begin(Fill fill) {
    if (!begun_) decisions_.begin(fill);
    begun_ = true;
  }

  /// Of the crossings of the sides on one side, taken as lines, the one that bounds the polygon in
  /// a row is the rightmost of the left ones, the leftmost of the right ones.
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
        // How far from the middle between two centres; half a column on one.
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

  HWY_NOINLINE void decide_columns(Fill fill, int from, int to, int row_begin) {
    begin(fill);
    for (int row = from; row < to; ++row) {
      columns_.first[row - row_begin] = columns_.end[row - row_begin] = 0;
    }
    for (const auto& span : decisions_.spans(from, to)) {
      columns_.first[span.row - row_begin] = span.first;
      columns_.end[span.row - row_begin] = span.end;
    }
  }

  HWY_INLINE void draw_span(const RowFill& f, Fill fill, int row, int first, int end) {
    const int lanes = static_cast<int>(hn::Lanes(f_));
    const Floats slope = hn::Set(f_, f.dz_dx);
    const float start = f.certain ? f.z + static_cast<float>(row - f.row_begin) * f.dz_dy +
                                        static_cast<float>(first - f.column) * f.dz_dx
                                  : std::numeric_limits<float>::quiet_NaN();
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
        if (HWY_UNLIKELY(!hn::AllFalse(f_, hn::AndNot(decided, covered)))) {
          begin(fill);
          return draw_closely(fill, row, {first, i, end}, slope, start);
        }
        const auto nearer = hn::And(covered, hn::Gt(nearer_by, margin_));
        store(nearer, z, old, own, z_row + i, fill_row + i);
      } else {
        store(hn::And(covered, hn::Ge(nearer_by, margin_)), z, old, own, z_row + i, fill_row + i);
      }
    }
  }

  /// A span, and the column from which on it is to be drawn.
  struct SpanLeft {
    int first, from, end;
  };

  /// What the fill drawn lies before or behind another by, along a row.
  struct RowDifference {
    Fill from;
    Floats start, slope, error;  ///< start: at the first column of the span
  };
  HWY_INLINE RowDifference in_row(const DepthDifference& d, int row, int first) const {
    const double start = d.z + d.dz_dy * row + d.dz_dx * first;
    return {d.from, hn::Set(f_, static_cast<float>(start)),
            hn::Set(f_, static_cast<float>(d.dz_dx)), hn::Set(f_, d.error)};
  }

  /// Where depths are too close: a pixel that shows the fill which was close last is decided by the
  /// difference of the two depths, which is known better than each of them.
  HWY_NOINLINE void draw_closely(Fill fill, int row, const SpanLeft& span, Floats slope,
                                 float start) {
    const int lanes = static_cast<int>(hn::Lanes(f_));
    const auto own = hn::Set(u_, fill);
    const Floats step = hn::Set(f_, static_cast<float>(lanes));
    float* const z_row = rows_.z + rows_.index(row, 0);
    Fill* const fill_row = rows_.fill + rows_.index(row, 0);
    RowDifference close = in_row(differences_[last_close_], row, span.first);
    Floats offset = hn::Iota(f_, static_cast<float>(span.from - span.first));
    for (int i = span.from; i < span.end; i += lanes, offset = hn::Add(offset, step)) {
      const auto covered = hn::FirstN(f_, static_cast<std::size_t>(span.end - i));
      const Floats z = hn::MulAdd(slope, offset, hn::Set(f_, start));
      const Floats old = hn::LoadU(f_, z_row + i);
      const Floats nearer_by = hn::Sub(z, old);
      FloatMask nearer = hn::And(covered, hn::Gt(nearer_by, margin_));
      FloatMask undecided = hn::AndNot(hn::Gt(hn::Abs(nearer_by), margin_), covered);
      const auto shown = hn::LoadU(u_, fill_row + i);
      const auto shows_close = [&] {
        return hn::And(undecided, hn::RebindMask(f_, hn::Eq(shown, hn::Set(u_, close.from))));
      };
      const auto decide_close = [&](FloatMask same) {
        const Floats by = hn::MulAdd(close.slope, offset, close.start);
        nearer = hn::Or(nearer, hn::And(same, hn::Gt(by, close.error)));
        return hn::AndNot(hn::Gt(hn::Abs(by), close.error), same);
      };
      FloatMask same = shows_close();
      FloatMask too_close = decide_close(same);
      undecided = hn::AndNot(same, undecided);
      while (HWY_UNLIKELY(!hn::AllFalse(f_, undecided))) {
        const Fill other = fill_row[i + static_cast<int>(hn::FindKnownFirstTrue(f_, undecided))];
        close = in_row(difference_from(other), row, span.first);
        same = shows_close();
        too_close = hn::Or(too_close, decide_close(same));
        undecided = hn::AndNot(same, undecided);
      }
      store(nearer, z, old, own, z_row + i, fill_row + i);
      if (HWY_UNLIKELY(!hn::AllFalse(f_, too_close)) && draw_exactly(row, i, too_close)) {
        forget_differences();
        close = in_row(differences_[last_close_], row, span.first);
      }
    }
  }

  HWY_INLINE bool draw_exactly(int row, int column, FloatMask pixels) {
    alignas(8) std::uint8_t bits[8] = {};
    hn::StoreMaskBits(f_, pixels, bits);
    return decisions_.draw(row, column, static_cast<std::uint32_t>(bits[0] | bits[1] << 8));
  }

  void forget_differences() {
    differences_known_ = 1;  // what is drawn over the background is seen
    last_close_ = 0;
    differences_[0] = {.from = FillScene::kBackground, .z = 1.0};
  }

  const DepthDifference& difference_from(Fill other) {
    const std::size_t known = std::min(differences_known_, differences_.size());
    for (std::size_t k = 0; k < known; ++k) {
      if (differences_[k].from != other) continue;
      last_close_ = k;
      return differences_[k];
    }
    last_close_ = 1 + (differences_known_++ - 1) % (differences_.size() - 1);
    return differences_[last_close_] = decisions_.difference_from(other);
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
  Columns columns_;
  bool begun_ = false;
  /// Of the fill begun: from the background, and then from those that were asked for last.
  std::array<DepthDifference, 5> differences_;
  std::size_t differences_known_ = 0;  // ever: the oldest make way
  std::size_t last_close_ = 0;         // that which was used last
};

template <bool kExact>
void draw_all(const RowFills& fills, std::span<const Fill> to_draw, const BandRows& rows,
              BandDecisions& decisions) {
  RowDrawer<kExact> drawer(fills, rows, decisions);
  for (const Fill fill : to_draw) drawer.draw(fill);
}

void DrawExact(const RowFills& fills, std::span<const Fill> to_draw, const BandRows& rows,
               BandDecisions& decisions) {
  draw_all<true>(fills, to_draw, rows, decisions);
}
void DrawRounded(const RowFills& fills, std::span<const Fill> to_draw, const BandRows& rows,
                 BandDecisions& decisions) {
  draw_all<false>(fills, to_draw, rows, decisions);
}

}  // namespace displayfile::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace displayfile {

HWY_EXPORT(DrawExact);
HWY_EXPORT(DrawRounded);

void draw_into_band(const RowFills& fills, std::span<const FillScene::Fill> to_draw,
                    const BandRows& rows, BandDecisions& decisions) {
  HWY_DYNAMIC_DISPATCH(DrawExact)(fills, to_draw, rows, decisions);
}

void draw_into_band_rounded(const RowFills& fills, std::span<const FillScene::Fill> to_draw,
                            const BandRows& rows, BandDecisions& decisions) {
  HWY_DYNAMIC_DISPATCH(DrawRounded)(fills, to_draw, rows, decisions);
}

}  // namespace displayfile
#endif
