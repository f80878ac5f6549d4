#pragma once

#include <vector>

#include "interp/vector/pens/stroke_chains.h"

namespace displayfile {

/// Cuts paths into dashes, lengths in units drawn and left out in turn, each path from its start
/// and around its corners: a pen knows no dashes. Where they would be shorter than kShortestDashes,
/// drawn and left out together, the whole path is drawn; and so is a dot.
std::vector<Stroke> dashes(const std::vector<PenPath>& paths, double drawn, double left_out);
inline constexpr double kShortestDashes = 10.0;

}  // namespace displayfile
