#pragma once

#include <vector>

#include "interp/vector/pens/stroke_chains.h"

namespace displayfile {

/// The way of the pen while it is up, in units: from the end of each path to the start of the next.
double travel(const std::vector<PenPath>& paths);

/// Puts paths in an order, each in one of its directions and a closed one from one of its points,
/// in which the pen travels little (interp/vector/pens/pen_order.md): first always to what is
/// nearest, beginning at the sheet's upper left corner, then improved by exchanges until none is
/// left that makes the way shorter. A function of the paths alone. The time grows little more than
/// their number.
void order_for_pen(std::vector<PenPath>& paths);

}  // namespace displayfile
