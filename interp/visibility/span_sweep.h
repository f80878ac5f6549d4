#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "interp/visibility/active_polygons.h"
#include "interp/visibility/close_depths.h"

namespace displayfile {

/// One scan line without a z-buffer: finds, from the runs of pixels in which polygons are IN, the
/// visible one in each span between two ends (interp/visibility/scan_line.md). For one thread.
class SpanSweep {
 public:
  using Fill = ViewedScene::Fill;

  struct Counts {
    std::uint64_t spans = 0;        ///< runs in which a polygon is IN
    std::uint64_t painted = 0;      ///< runs of pixels painted, without the background's
    std::uint64_t comparisons = 0;  ///< of two fills at a centre
    std::uint64_t crossovers = 0;   ///< found between polygons that interpenetrate
  };

  SpanSweep(CloseDepths& close, int width);

  void begin_row(int row);
  /// A run of columns, first < end, of this row in which a polygon is IN.
  void add(const ActivePolygons::Polygon& polygon, ActivePolygons::Index index, int first, int end);

  /// Writes the fill visible at each centre of the row. Calls hidden(polygon, other) if a polygon's
  /// entire run is hidden by the other's.
  template <class Hidden>
  void sweep(std::span<Fill> seen, Hidden&& hidden);

  const Counts& counts() const { return counts_; }

 private:
  using Index = std::uint32_t;
  static constexpr Index kNone = ~Index{0};
  static constexpr int kNever = std::numeric_limits<int>::max();

  /// A run, in a bucket of those that begin in the same column, later in a pairing heap: none of
  /// its children is visible before it ends, or before they are due.
  struct Span {
    double z, dz_dx, x0, error;  ///< depth in this row at x0, and its slope
    Fill fill;
    int first, end;
    int due;            ///< the column from which its parent may fail to hide it
    Index child, next;  ///< the first child; the next sibling, or the next in its bucket
    Index before;       ///< the previous sibling, or for the first child its parent
    std::uint32_t polygon : 31, may_rest : 1;
    double depth(int column) const { return z + dz_dx * (column + 0.5 - x0); }
  };
  struct Due {
    int column;
    Index span;
    bool operator<(const Due& other) const {  // the first on top
      return column != other.column ? column > other.column : span > other.span;
    }
  };

  bool hides(const Span& a, const Span& b, int column);
  template <class Hidden>
  Index meld(Index a, Index b, int column, Hidden&& hidden);
  void hang(Index loser, Index winner);
  void cut(Index span);
  void falls_due(Index span, int column);
  int crossover(const Span& seen, const Span& other, int column, int last);
  template <class Hidden>
  Index after_end(Index ended, int column, Hidden&& hidden);
  template <class Hidden>
  Index decide_due(Index seen, int column, Hidden&& hidden);
  int next_begin(int column) const;

  CloseDepths* close_;
  int width_, row_ = 0;
  std::vector<Span> spans_;
  std::vector<Index> bucket_;          // of each column
  std::vector<std::uint64_t> begins_;  // a bit for each column whose bucket is not empty
  std::vector<Due> due_;               // a heap; some are of the past
  std::vector<Index> heirs_;
  Counts counts_;
};

inline void SpanSweep::begin_row(int row) {
  row_ = row;
  spans_.clear();
  due_.clear();
}

inline void SpanSweep::add(const ActivePolygons::Polygon& polygon, ActivePolygons::Index index,
                           int first, int end) {
  const PixelDepth& depth = polygon.depth;
  auto& bucket = bucket_[static_cast<std::size_t>(first)];
  spans_.push_back({depth.row(row_), depth.dz_dx, depth.x0, polygon.error, polygon.fill, first, end,
                    kNever, kNone, bucket, kNone, index & 0x7FFFFFFFu,
                    polygon.may_rest_from <= row_});
  bucket = static_cast<Index>(spans_.size() - 1);
  begins_[static_cast<std::size_t>(first) / 64] |= std::uint64_t{1} << (first % 64);
}

/// As CloseDepths::hides, from local data.
inline bool SpanSweep::hides(const Span& a, const Span& b, int column) {
  ++counts_.comparisons;
  const double nearer = a.depth(column) - b.depth(column);
  const double margin = 2.0 * (a.error + b.error);
  if (nearer > margin) return true;
  if (nearer < -margin) return false;
  return close_->hides_closely(a.fill, b.fill, column, row_);
}

/// Returns the one of two spans, neither ended at the column, that is visible there; the other
/// becomes its child. Later columns are compared at the last one that both cover: along a row one
/// plane passes another at most once.
template <class Hidden>
SpanSweep::Index SpanSweep::meld(Index a, Index b, int column, Hidden&& hidden) {
  const bool a_seen = hides(spans_[a], spans_[b], column);
  const Index winner = a_seen ? a : b, loser = a_seen ? b : a;
  const Span& seen = spans_[winner];
  Span& behind = spans_[loser];
  const int last = std::min(seen.end, behind.end) - 1;
  if (last > column && hides(behind, seen, last)) {
    falls_due(loser, crossover(seen, behind, column, last));
    hang(loser, winner);
    return winner;
  }
  if (behind.end <= seen.end) {
    if (behind.may_rest && behind.first == column) hidden(behind.polygon, seen.polygon);
    if (behind.child == kNone) return winner;  // never seen
    // After it ends, nothing is known to hide the spans behind it.
    if (behind.end < seen.end) falls_due(loser, behind.end);
  }
  hang(loser, winner);
  return winner;
}

/// The spans behind one that has ended compete for its place, two by two and then all with the last
/// (the pairing heap's two passes).
template <class Hidden>
SpanSweep::Index SpanSweep::after_end(Index ended, int column, Hidden&& hidden) {
  heirs_.clear();
  for (Index child = spans_[ended].child; child != kNone; child = spans_[child].next) {
    heirs_.push_back(child);
  }
  std::size_t living = 0;
  for (std::size_t k = 0; k < heirs_.size(); ++k) {  // grows
    const Index heir = heirs_[k];
    spans_[heir].due = kNever;
    if (spans_[heir].end > column) {
      heirs_[living++] = heir;
      continue;
    }
    for (Index child = spans_[heir].child; child != kNone; child = spans_[child].next) {
      heirs_.push_back(child);
    }
  }
  heirs_.resize(living);
  if (heirs_.empty()) return kNone;
  for (std::size_t k = 0; k + 1 < heirs_.size(); k += 2) {
    heirs_[k / 2] = meld(heirs_[k], heirs_[k + 1], column, hidden);
  }
  if (living % 2 == 1) heirs_[living / 2] = heirs_[living - 1];
  heirs_.resize((living + 1) / 2);
  Index nearest = heirs_.back();
  for (std::size_t k = heirs_.size() - 1; k-- > 0;) {
    nearest = meld(nearest, heirs_[k], column, hidden);
  }
  return nearest;
}

/// The spans due at the column, and their remainders, compete with the visible span.
template <class Hidden>
SpanSweep::Index SpanSweep::decide_due(Index seen, int column, Hidden&& hidden) {
  while (!due_.empty() && due_.front().column <= column) {
    const Index span = due_.front().span;
    const bool still = spans_[span].due == due_.front().column;
    std::pop_heap(due_.begin(), due_.end());
    due_.pop_back();
    if (!still) continue;
    cut(span);
    const Index heir = spans_[span].end > column ? span : after_end(span, column, hidden);
    if (heir != kNone) seen = meld(seen, heir, column, hidden);
  }
  return seen;
}

template <class Hidden>
void SpanSweep::sweep(std::span<Fill> seen, Hidden&& hidden) {
  counts_.spans += spans_.size();
  Index front = kNone;
  Fill before = ViewedScene::kBackground;
  for (int column = 0; column < width_;) {
    if (front != kNone && spans_[front].end <= column) front = after_end(front, column, hidden);
    front = decide_due(front, column, hidden);
    Index& bucket = bucket_[static_cast<std::size_t>(column)];
    for (Index span = bucket; span != kNone;) {
      const Index next = spans_[span].next;
      front = front == kNone ? span : meld(front, span, column, hidden);
      span = next;
    }
    bucket = kNone;
    begins_[static_cast<std::size_t>(column) / 64] &= ~(std::uint64_t{1} << (column % 64));

    int end = next_begin(column);
    Fill fill = ViewedScene::kBackground;
    if (front != kNone) {
      end = std::min(end, spans_[front].end);
      fill = spans_[front].fill;
      counts_.painted += fill != before;
    }
    if (!due_.empty()) end = std::min(end, due_.front().column);
    before = fill;
    std::fill(seen.begin() + column, seen.begin() + end, fill);
    column = end;
  }
}

}  // namespace displayfile
