#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/surface_plan.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The lines of some items, and what is seen of them: found once, for all that is drawn of them.
struct FoundLines {
  std::vector<LineToDraw> lines;                ///< by item and corner
  std::vector<IntersectionLine> intersections;  ///< none if they are not wanted
  SeenLines seen;                               ///< of both
  /// With a ROUNDOFF, what it is as a length in the projection: shorter pieces are rounding's.
  double least_length = 0.0;
};

/// All lines that are drawn (lines_to_draw: of items that have no line style no side may be
/// visible), intersections if the plan has them, and what its method sees of them. `picks`
/// are the items' pick identifiers; empty: all are equal. Throws Error for a method that finds no
/// lines.
FoundLines find_lines(const Primitives& items, std::span<const std::int32_t> picks,
                      const SurfacePlan& plan);

/// What is seen of the lines, as pieces of two points, and before them, if they are `dashed`, what
/// is not seen and not covered (uncovered_pieces). They are in order of chains (chains_of); pieces
/// of different kinds are not joined, nor are those of items of different `groups`; empty: all are
/// of one. The ends of a line are the item's own points; others are computed from those and
/// rounded. A piece whose ends become one point in the projection, or that is no longer than
/// least_length, is left out, which would be drawn as a dot.
///
/// A piece of a side that polygons share is the first's that draws it, has all kinds that it is
/// drawn as (SortedPieces::visible of its second point), and names the item of the lowest of their
/// pick identifiers. Intersections are pieces of the polygon that was entered later.
SortedPieces lines_in_order(const Primitives& items, std::span<const std::uint32_t> groups,
                            const FoundLines& found, HiddenLines hidden_lines);

/// Those of them that fills with their sides do not show, in the same order: the hidden ones, and
/// what is seen of intersections.
SortedPieces lines_beside_sides(const Primitives& items, std::span<const std::uint32_t> groups,
                                const FoundLines& found, HiddenLines hidden_lines);

}  // namespace displayfile
