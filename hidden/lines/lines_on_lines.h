#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A line in the picture; its ends differ.
struct LineOfPicture {
  Point2 from, to;
};

/// Lines that are no farther apart than this share of the picture are drawn over each other.
inline constexpr double kLinesApart = 1e-9;

/// Finds lines that lie on each other (hidden/lines/hidden_pieces.md): for each line the number of
/// its leader, a line that is not shorter. From the longest line to the shortest, equally long ones
/// in order, each line follows the first earlier leader from whose supporting line none of its ends
/// is farther than kLinesApart, and else leads itself. Beyond the leader's ends up to three times
/// as much is allowed: where both run they are then no farther apart than twice kLinesApart. Lines
/// shorter than 2^17 kLinesApart must be closer, by as much as they are shorter. Rounding of
/// coordinates that are larger than the picture is allowed for.
std::vector<std::uint32_t> leading_lines(std::span<const LineOfPicture> lines);

}  // namespace displayfile
