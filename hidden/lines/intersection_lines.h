#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/exact/defined_point.h"
#include "hidden/primitives.h"

namespace displayfile {

class LineTable;

/// A part of a line along which two solid polygons pass through each other. Device coordinates.
struct IntersectionLine {
  std::uint32_t item_a, item_b;  ///< a was entered before b
  /// Its ends, the one that is lower by x, then y, first. They are kept as what they are, of
  /// Definitions of the items' points and two planes, the support planes of a and of b; `near` has
  /// each coordinate rounded once, to the nearest double. Different in the projection, also so.
  DefinedPoint from, to;
  /// Where it is drawn: the rounded ends. An end on a side of a polygon that is not flat is drawn
  /// where that side, as it was entered, meets the other's plane: there the lines of all polygons
  /// that share the side end.
  Point3 start, end;
};

/// Where solid polygons pass through each other (hidden/lines/intersection_lines.md has the
/// definition): in order of item_b, item_a, and of places along the line that both planes have in
/// common. Edge-on polygons have none. Exact; the same for any number of threads.
std::vector<IntersectionLine> intersection_lines(const Primitives& items, int threads = 1);

/// What is kept of an intersection line's ends.
enum class IntersectionEnds {
  rounded,  ///< to be drawn: `near` is rounded once; lines whose ends are rounded alike are left
            ///< out, and those of polygons that share a side
  defined,  ///< `near` is close to the end, so that filters decide; nothing is drawn, and no line
            ///< left out
};

/// The same among some polygons, which hide. The scene is of the same items.
std::vector<IntersectionLine> intersection_lines(const Primitives& items, const LineTable& scene,
                                                 std::span<const std::uint32_t> polygons,
                                                 IntersectionEnds ends, int threads);

}  // namespace displayfile
