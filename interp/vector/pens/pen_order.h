#pragma once

#include <vector>

#include "interp/vector/pens/stroke_chains.h"

namespace displayfile {

/// The distance travelled with the pen up, in units: from the end of each path to the start of the
/// next.
double travel(const std::vector<PenPath>& paths);

/// Orders paths, each in either direction and a closed one from any of its points, for short pen
/// travel (interp/vector/pens/pen_order.md): first nearest neighbour from the sheet's upper left
/// corner, then exchanges until none shortens the travel. A function of the paths alone. The time
/// is nearly proportional to their number. `from`: the pen's initial place.
void order_for_pen(std::vector<PenPath>& paths, const SheetPoint& from = {0, 0});

}  // namespace displayfile
