#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A line in the picture; its ends differ.
struct LineOfPicture {
  Point2 from, to;
};

/// Lines within this fraction of the picture are drawn over each other.
inline constexpr double kLinesApart = 1e-9;

/// The same for a scene in which points within reach may be `touching` apart per coordinate
/// (Primitives::touching, which overestimates it about fourfold): a quarter of that, if larger, and
/// at most 1e-3.
inline double lines_apart(double touching) {
  return std::clamp(0.25 * touching, kLinesApart, 1e-3);
}

/// Finds lines that lie on each other (hidden/lines/hidden_pieces.md): for each line the index of
/// its leader, a line that is not shorter. From the longest to the shortest, equally long ones in
/// order, each line follows the first earlier leader from whose supporting line neither of its ends
/// is farther than `apart`, and otherwise leads itself. Beyond the leader's ends up to three times
/// as much is allowed: where both run they are then within twice that. Short lines must be closer:
/// within 2^-17 of their length, or 32 times `apart` if that is more. Rounding of coordinates
/// larger than the picture is allowed for.
std::vector<std::uint32_t> leading_lines(std::span<const LineOfPicture> lines,
                                         double apart = kLinesApart);

}  // namespace displayfile
