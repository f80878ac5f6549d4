#pragma once

namespace displayfile {

/// Pixels of a row from the first asked for up to `end`: is the later of two polygons seen on all
/// of them, or on none, rather than the one entered before it?
struct DecidedRun {
  int end;
  bool later_is_seen;
};

/// Of columns first <= i < end, which both polygons cover; at least one of them. later_is_seen(i)
/// tells it, truly, for one column.
///
/// Along a row the difference of two depths is linear: if it has one sign at both ends of a run,
/// it has that sign between them; if not, it changes once.
template <class LaterIsSeen>
DecidedRun run_of(int first, int end, LaterIsSeen&& later_is_seen) {
  constexpr int kFew = 5;  // as soon asked one by one
  const bool seen = later_is_seen(first);
  if (end - first < kFew) return {first + 1, seen};
  int same = first;
  for (int different = end; different - same > 1;) {
    const int middle = different == end ? end - 1 : same + (different - same) / 2;
    (later_is_seen(middle) == seen ? same : different) = middle;
  }
  return {same + 1, seen};
}

}  // namespace displayfile
