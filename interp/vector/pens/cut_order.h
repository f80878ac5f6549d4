#pragma once

#include <cstdint>
#include <vector>

#include "interp/vector/pens/stroke_chains.h"

namespace displayfile {

/// Splits paths where they return to a point: each loop becomes a closed path, and the rest of an
/// open path stays open. Each stroke is still drawn once.
std::vector<PenPath> simple_paths(const std::vector<PenPath>& paths);

/// For each path, the number of closed paths that contain it. A closed path contains another if no
/// corner and no middle of a side of the other lies outside, by the even-odd rule, and at least one
/// lies inside; corners and middles are exact. Coincident paths do not contain each other.
std::vector<std::uint32_t> nesting_depths(const std::vector<PenPath>& paths);

/// Splits paths into simple ones, and orders them for a cutter (interp/vector/pens/pen_order.md):
/// deeper ones first, so that nothing is cut in a piece that has fallen out; those of one depth for
/// short travel.
void order_for_cutting(std::vector<PenPath>& paths);

}  // namespace displayfile
