#pragma once

#include <span>
#include <vector>

#include "hidden/lines/visible_lines.h"

namespace displayfile {

/// A hidden part of a line, in the same form as a visible one.
using HiddenPiece = VisiblePiece;

/// The hidden parts of the lines: together with the visible pieces, the whole of each line once,
/// from 0 to 1. `lines` are sorted and unique, and include all lines of `seen`; none projects to a
/// point. By item, corner, from.
std::vector<HiddenPiece> hidden_pieces(std::span<const LineName> lines, const SeenLines& seen);

/// The hidden pieces minus the parts covered by a visible piece of another line in the projection;
/// where hidden pieces cover each other, only that of the first line by item and corner is kept
/// (hidden/lines/hidden_pieces.md). Lines cover each other if they are no farther apart than
/// lines_apart (hidden/lines/lines_on_lines.h), in device coordinates. By item, corner, from.
std::vector<HiddenPiece> uncovered_pieces(const Primitives& items, const SeenLines& seen,
                                          std::span<const HiddenPiece> hidden);

}  // namespace displayfile
