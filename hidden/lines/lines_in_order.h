#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/surfaces.h"
#include "hidden/lines/visible_lines.h"
#include "hidden/primitives.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The lines of some items and their visible parts, found once for all drawing.
struct FoundLines {
  std::vector<LineToDraw> lines;                ///< by item and corner
  std::vector<IntersectionLine> intersections;  ///< empty unless in the plan
  SeenLines seen;                               ///< of both
  /// ROUNDOFF, if used, as a length in the projection: shorter pieces are rounding artefacts.
  double least_length = 0.0;
};

/// All drawn lines (lines_to_draw: for items without a line style no side may be visible),
/// intersection lines if the plan has them, and their visible parts by its method. `picks` are the
/// items' pick identifiers; empty: all equal. Throws Error for a method that finds no lines.
FoundLines find_lines(const Primitives& items, std::span<const std::int32_t> picks,
                      const SurfacePlan& plan);

/// The visible parts of the lines as pieces of two points, preceded, if `dashed`, by the hidden and
/// uncovered parts (uncovered_pieces). They are in order of chains (chains_of); pieces of different
/// kinds are not joined, nor are those of items of different `groups`; empty: one group. The ends
/// of a line are the item's own points; others are computed from those and rounded. Pieces whose
/// ends coincide in the projection, or that are no longer than least_length, are omitted, since
/// they would be drawn as dots.
///
/// A piece of a shared side belongs to the first polygon that draws it, has all kinds as which it
/// is drawn (SortedPieces::visible of its second point), and names the item with the lowest of
/// their pick identifiers. Intersection lines belong to the polygon entered later.
SortedPieces lines_in_order(const Primitives& items, std::span<const std::uint32_t> groups,
                            const FoundLines& found, HiddenLines hidden_lines);

/// The pieces among them that are not sides of drawn fills, in the same order: hidden ones, and
/// visible parts of intersection lines.
SortedPieces lines_beside_sides(const Primitives& items, std::span<const std::uint32_t> groups,
                                const FoundLines& found, HiddenLines hidden_lines);

}  // namespace displayfile
