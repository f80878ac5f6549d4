#pragma once

#include <span>
#include <vector>

#include "interp/vector/disjoint_fills.h"

namespace displayfile {

/// The traps of a figure (interp/vector/seams.md): each side of its regions, once, in the paint of
/// the first region that has it. Paths are no longer than the figure's. O(n log n).
std::vector<FigureTrap> traps_of(std::span<const FigureRegion> regions);

}  // namespace displayfile
