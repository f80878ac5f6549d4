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

/// Lines that are no farther apart than this share of the picture are drawn over each other.
inline constexpr double kLinesApart = 1e-9;

/// The same of a scene in which what is within reach may be apart by `touching` in each coordinate
/// (Primitives::touching, which bounds it by about four times as much): a quarter of that, if it is
/// more, and at most 1e-3.
inline double lines_apart(double touching) {
  return std::clamp(0.25 * touching, kLinesApart, 1e-3);
}

/// Finds lines that lie on each other (hidden/lines/hidden_pieces.md): for each line the number of
/// its leader, a line that is not shorter. From the longest line to the shortest, equally long ones
/// in order, each line follows the first earlier leader from whose supporting line none of its ends
/// is farther than `apart`, and else leads itself. Beyond the leader's ends up to three times
/// as much is allowed: where both run they are then no farther apart than twice that. Short lines
/// must be closer: by no more than a part of their length, 2^-17, or 32 times `apart` if that is
/// more. Rounding of coordinates that are larger than the picture is allowed for.
std::vector<std::uint32_t> leading_lines(std::span<const LineOfPicture> lines,
                                         double apart = kLinesApart);

}  // namespace displayfile
