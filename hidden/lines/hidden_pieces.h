#pragma once

#include <span>
#include <vector>

#include "hidden/lines/visible_lines.h"

namespace displayfile {

/// A part of a line that is not seen: as of one that is.
using HiddenPiece = VisiblePiece;

/// What is left of the lines where they are not seen: together with the pieces that are seen, the
/// whole of each line once, from 0 to 1. `lines` are in order, each once, and are all that `seen`
/// has pieces of; none projects to a point. By item, corner, from.
std::vector<HiddenPiece> hidden_pieces(std::span<const LineName> lines, const SeenLines& seen);

/// The hidden pieces without what a visible piece of another line covers in the projection, and
/// where hidden pieces cover each other with one of them, that of the first line by item and corner
/// (hidden/lines/hidden_pieces.md). Lines cover each other that are no farther apart than
/// lines_apart (hidden/lines/lines_on_lines.h), in device coordinates. By item, corner, from.
std::vector<HiddenPiece> uncovered_pieces(const Primitives& items, const SeenLines& seen,
                                          std::span<const HiddenPiece> hidden);

}  // namespace displayfile
