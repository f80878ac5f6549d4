#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/lines/lines_on_lines.h"

namespace displayfile {

/// A piece of a line of the picture: from and to are shares of it, 0 <= from < to <= 1.
struct RankedPiece {
  std::uint32_t line;
  double from, to;
  std::uint32_t rank;  ///< where pieces lie on each other the lowest is drawn, or the first of them
  std::uint32_t group;  ///< pieces of other groups are not looked at
  bool is_wanted;       ///< only these are returned; others cover
};

/// The drawn part of a piece, in shares of its line.
struct DrawnPart {
  std::uint32_t piece;
  double from, to;
};

/// The pieces that are wanted, without what others of their group cover
/// (hidden/lines/hidden_pieces.md): where several lie on one line, but for rounding
/// (leading_lines), each place of it is drawn by one. Pieces are ordered by lines. A piece that is
/// alone is returned as it is. By piece, from.
std::vector<DrawnPart> uppermost_parts(std::span<const LineOfPicture> lines,
                                       std::span<const RankedPiece> pieces,
                                       double apart = kLinesApart);

}  // namespace displayfile
