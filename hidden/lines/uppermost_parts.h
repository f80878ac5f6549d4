#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/lines/lines_on_lines.h"

namespace displayfile {

/// A piece of a line of the picture: from and to are fractions of it, 0 <= from < to <= 1.
struct RankedPiece {
  std::uint32_t line;
  double from, to;
  std::uint32_t rank;   ///< of overlapping pieces the lowest is drawn, in ties the first
  std::uint32_t group;  ///< pieces of other groups are ignored
  bool is_wanted;       ///< returned; others only cover
};

/// The drawn part of a piece, in fractions of its line.
struct DrawnPart {
  std::uint32_t piece;
  double from, to;
};

/// The wanted pieces, without the parts covered by others of their group
/// (hidden/lines/hidden_pieces.md): where several lie on one line, up to rounding (leading_lines),
/// each position is drawn by one. Pieces are ordered by lines. A single piece is returned
/// unchanged. By piece, from.
std::vector<DrawnPart> uppermost_parts(std::span<const LineOfPicture> lines,
                                       std::span<const RankedPiece> pieces,
                                       double apart = kLinesApart);

}  // namespace displayfile
