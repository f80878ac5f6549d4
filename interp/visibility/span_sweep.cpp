#include "interp/visibility/span_sweep.h"

#include <bit>
#include <cmath>

namespace displayfile {

SpanSweep::SpanSweep(CloseDepths& close, int width)
    : close_(&close),
      width_(width),
      bucket_(static_cast<std::size_t>(width), kNone),
      begins_(static_cast<std::size_t>(width) / 64 + 1, 0) {}

/// The next column in which a span begins, or the width.
int SpanSweep::next_begin(int column) const {
  auto word = static_cast<std::size_t>(column) / 64;
  std::uint64_t bits = begins_[word] & (~std::uint64_t{0} << (column % 64));
  while (bits == 0) {
    if (++word == begins_.size()) return width_;
    bits = begins_[word];
  }
  return static_cast<int>(word * 64) + std::countr_zero(bits);
}

void SpanSweep::hang(Index loser, Index winner) {
  Span& child = spans_[loser];
  Span& parent = spans_[winner];
  child.next = parent.child;
  child.before = winner;
  if (child.next != kNone) spans_[child.next].before = loser;
  parent.child = loser;
}

void SpanSweep::cut(Index span) {
  Span& cut_off = spans_[span];
  Span& before = spans_[cut_off.before];
  (before.child == span ? before.child : before.next) = cut_off.next;
  if (cut_off.next != kNone) spans_[cut_off.next].before = cut_off.before;
  cut_off.due = kNever;
}

void SpanSweep::falls_due(Index span, int column) {
  spans_[span].due = column;
  due_.push_back({column, span});
  std::push_heap(due_.begin(), due_.end());
}

/// The first column at which the other is visible, of two whose order differs at `column` and at
/// `last`: the lecture's N = (z* - z) / (dz - dz*) columns on, if a comparison confirms it;
/// otherwise found by bisection.
int SpanSweep::crossover(const Span& seen, const Span& other, int column, int last) {
  ++counts_.crossovers;
  int before = column, after = last;
  const double n = (seen.depth(column) - other.depth(column)) / (other.dz_dx - seen.dz_dx);
  if (n > 0.0 && n < last - column) {
    const int guess = column + static_cast<int>(std::ceil(n));
    (hides(other, seen, guess) ? after : before) = guess;
    if (after == guess && guess - 1 > before) {
      (hides(other, seen, guess - 1) ? after : before) = guess - 1;
    } else if (before == guess && guess + 1 < after) {
      (hides(other, seen, guess + 1) ? after : before) = guess + 1;
    }
  }
  while (after - before > 1) {
    const int middle = before + (after - before) / 2;
    (hides(other, seen, middle) ? after : before) = middle;
  }
  return after;
}

}  // namespace displayfile
