#pragma once

#include "hidden/hidden_method.h"
#include "hidden/primitives.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// What is seen of all lines that are drawn (drawn_lines: of items that have no line style no side
/// may be visible), as pieces of two points in order of
/// items and corners, each from where its line starts to where it ends. The ends of a line are the
/// item's own points; others are computed from those and rounded. Throws Error for a method that
/// finds no lines.
SortedPieces lines_in_order(const Primitives& items, HiddenMethod method,
                            const SortOptions& options);

}  // namespace displayfile
