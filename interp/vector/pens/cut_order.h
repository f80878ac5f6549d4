#pragma once

#include <cstdint>
#include <vector>

#include "interp/vector/pens/stroke_chains.h"

namespace displayfile {

/// Opens paths where they come back to a point: each loop is a closed path of its own, and the rest
/// of an open path stays open. Each stroke stays drawn once.
std::vector<PenPath> simple_paths(const std::vector<PenPath>& paths);

/// For each path the number of closed paths that contain it. A closed path contains another one if
/// no corner and no middle of a side of that lies outside of it, by the even-odd rule, and one lies
/// inside; corners and middles are exact. Paths that coincide contain each other not.
std::vector<std::uint32_t> nesting_depths(const std::vector<PenPath>& paths);

/// Splits paths into simple ones, and orders them for a cutter (interp/vector/pens/pen_order.md):
/// deeper ones first, so that nothing is cut in a piece that has fallen out; those of one depth for
/// short travel.
void order_for_cutting(std::vector<PenPath>& paths);

}  // namespace displayfile
