#pragma once

namespace displayfile {

/// The columns of a row, up to `end`, where the later of two polygons hides the one entered before
/// it: before the column of the change or from it on.
struct DecidedRun {
  int change, end;
  bool seen_before_change;

  bool later_is_seen(int column) const { return (column < change) == seen_before_change; }
  struct Columns {
    int first, end;
  };
  /// The columns from `first` on where the later polygon is visible.
  Columns seen_from(int first) const {
    return seen_before_change ? Columns{first, change} : Columns{change, end};
  }
};

/// Decides the columns first <= i < end, at least one, all of which both polygons cover.
/// later_is_seen(i) returns exactly whether the later polygon is visible in one column.
///
/// Along a row the difference of two depths is linear: if it has one sign at both ends of a run,
/// it has that sign between them; if not, it changes once, and halving finds where.
template <class LaterIsSeen>
DecidedRun run_of(int first, int end, LaterIsSeen&& later_is_seen) {
  const bool before = later_is_seen(first);
  if (end - first == 1 || later_is_seen(end - 1) == before) return {end, end, before};
  int same = first, different = end - 1;
  while (different - same > 1) {
    const int middle = same + (different - same) / 2;
    (later_is_seen(middle) == before ? same : different) = middle;
  }
  return {different, end, before};
}

}  // namespace displayfile
