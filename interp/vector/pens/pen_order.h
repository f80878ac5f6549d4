#pragma once

#include <vector>

#include "interp/vector/pens/stroke_chains.h"

namespace displayfile {

/// The way of the pen while it is up, in units: from the end of each path to the start of the next.
double travel(const std::vector<PenPath>& paths);

/// Orders paths, each in one of its directions and a closed one from one of its points, for short
/// pen travel (interp/vector/pens/pen_order.md): first nearest neighbour from the sheet's upper
/// left corner, then improved by exchanges until none shortens the way. A function of the paths
/// alone. The time grows little more than their number. `from`: where the pen is at first.
void order_for_pen(std::vector<PenPath>& paths, const SheetPoint& from = {0, 0});

}  // namespace displayfile
