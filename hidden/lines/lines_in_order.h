#pragma once

#include <span>

#include "hidden/hidden_method.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// What is seen of all lines that are drawn (drawn_lines: of items that have no line style no side
/// may be visible), as pieces of two points in order of items and corners, each from where its line
/// starts to where it ends. The ends of a line are the item's own points; others are computed from
/// those and rounded. Throws Error for a method that finds no lines. Intersections, if the options
/// ask for them, are pieces of the polygon that was entered later, after its sides.
SortedPieces lines_in_order(const Primitives& items, HiddenMethod method,
                            const SortOptions& options);

/// The same of what was found to be seen of sides and intersections.
SortedPieces lines_in_order(const Primitives& items, const SeenLines& seen,
                            std::span<const IntersectionLine> intersections = {});

}  // namespace displayfile
