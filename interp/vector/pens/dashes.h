#pragma once

#include <vector>

#include "interp/vector/pens/stroke_chains.h"

namespace displayfile {

/// Cuts paths into dashes, with lengths in units drawn and left out alternately, each path from its
/// start and around its corners: pens have no dashes. Where a dash and its gap together would be
/// shorter than kShortestDashes, the whole path is drawn; so is a dot.
std::vector<Stroke> dashes(const std::vector<PenPath>& paths, double drawn, double left_out);
inline constexpr double kShortestDashes = 10.0;

}  // namespace displayfile
