#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/hidden_method.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// How lines of items are drawn.
struct LinesOfItems {
  std::span<const std::int32_t> picks;  ///< the items' pick identifiers; empty: all are equal
  /// Lines of items of different groups are not joined into chains; empty: all are of one.
  std::vector<std::uint32_t> groups;
};

/// What is seen of all lines that are drawn (drawn_lines: of items that have no line style no side
/// may be visible), as pieces of two points, and before them, if the options ask for hidden lines,
/// what is not seen and not covered (uncovered_pieces). They are in order of chains (chains_of);
/// pieces of different kinds are not joined. The ends of a line are the item's own points; others
/// are computed from those and rounded. Throws Error for a method that finds no lines.
///
/// A piece of a side that polygons share is the first's that draws it, has all kinds that it is
/// drawn as (SortedPieces::visible of its second point), and names the item of the lowest of their
/// pick identifiers. Intersections, if the options ask for them, are pieces of the polygon that was
/// entered later.
SortedPieces lines_in_order(const Primitives& items, const LinesOfItems& lines, HiddenMethod method,
                            const SortOptions& options);

/// The same of what was found to be seen of those lines, without what is hidden.
SortedPieces lines_in_order(const Primitives& items, const LinesOfItems& lines,
                            const SeenLines& seen);

}  // namespace displayfile
