#pragma once

#include <vector>

#include "interp/vector/pens/stroke_chains.h"

namespace displayfile::bench {

/// A length, in units, below which no order and no directions of these paths bring the travel of
/// the pen between them.
///
/// A way visits all paths, so the travel joins them: it is a spanning tree over the paths, and at
/// least as long as the shortest one, where an open path may be joined at either end and a closed
/// one at any of its points. Held and Karp ("The traveling-salesman problem and minimum spanning
/// trees", Operations Research 18, 1970) make that sharp: each end of an open path is left or
/// entered once, a closed path and a dot twice, but for the first and the last of the way. With any
/// price p on each end, every way costs its travel and the prices of the ends that it uses, so that
///   travel >= tree with prices - sum of (prices times uses) + the two least prices.
/// Prices rise where the shortest tree joins an end too often and fall where it does not join it
/// at all, over `rounds` rounds; the best bound is kept. Each round takes the square of the
/// number of points in time.
double travel_bound(const std::vector<PenPath>& paths, int rounds);

}  // namespace displayfile::bench
