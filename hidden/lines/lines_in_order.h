#pragma once

#include <cstdint>
#include <span>

#include "hidden/hidden_method.h"
#include "hidden/primitives.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// What is seen of all lines that are drawn (drawn_lines: of items that have no line style no side
/// may be visible), as pieces of two points in order of
/// items and corners, each from where its line starts to where it ends. The ends of a line are the
/// item's own points; others are computed from those and rounded. Throws Error for a method that
/// finds no lines.
///
/// A piece of a side that polygons share is the first's that draws it, has all kinds that it is
/// drawn as (SortedPieces::visible of its second point), and names the item of the lowest of their
/// pick identifiers, which `picks` are of the items.
SortedPieces lines_in_order(const Primitives& items, std::span<const std::int32_t> picks,
                            HiddenMethod method, const SortOptions& options);

}  // namespace displayfile
