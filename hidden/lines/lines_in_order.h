#pragma once

#include <cstdint>
#include <span>

#include "hidden/hidden_method.h"
#include "hidden/primitives.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// What is seen of all lines that are drawn (drawn_lines: of items that have no line style no side
/// may be visible), as pieces of two points, and before them, if the options ask for hidden lines,
/// what is not seen and not covered (uncovered_pieces). They are in order of chains (chains_of):
/// those of items of different groups are not joined; no groups are one. The ends of a line are the
/// item's own points; others are computed from those and rounded. Throws Error for a method that
/// finds no lines.
SortedPieces lines_in_order(const Primitives& items, HiddenMethod method,
                            const SortOptions& options, std::span<const std::uint32_t> groups = {});

}  // namespace displayfile
