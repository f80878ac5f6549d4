#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/exact/defined_point.h"
#include "hidden/primitives.h"

namespace displayfile {

class LineTable;

/// A segment along which two solid polygons intersect. Device coordinates.
struct IntersectionLine {
  std::uint32_t item_a, item_b;  ///< a was entered before b
  /// Its ends, the lower one by x, then y, first. They are exact, as Definitions of the items'
  /// points and two planes, the support planes of a and b; `near` has each coordinate rounded once,
  /// to the nearest double. Distinct in the projection, also when rounded.
  DefinedPoint from, to;
  /// The ends as drawn, rounded. An end on a side of a non-planar polygon is drawn where that side,
  /// as entered, meets the other's plane: there the lines of all polygons that share the side end.
  Point3 start, end;
};

/// The segments along which solid polygons intersect (hidden/lines/intersection_lines.md has the
/// definition): in order of item_b, item_a, and position on the common line of both planes. Edge-on
/// polygons have none. Exact; independent of the number of threads.
std::vector<IntersectionLine> intersection_lines(const Primitives& items, int threads = 1);

/// The form of an intersection line's ends.
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
