#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "hidden/map/map_place.h"
#include "hidden/primitives.h"

namespace displayfile {

/// The item visible at each point of the projection: the plane divided by edges, with one item
/// visible on the left and another on the right of each (hidden/map/visible_map.md). Device
/// coordinates.
///
/// Among the solid polygons that cover a point, the one with the nearest plane is visible, and
/// among coplanar ones the one entered last. Edge-on polygons, hollow ones and lines are not
/// included.
struct VisibleMap {
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

  /// From one vertex to another, distinct one; with the items visible beside it, kNothing for the
  /// background.
  struct Edge {
    std::uint32_t from, to;
    std::uint32_t left, right;
  };
  /// Edges meet only at vertices: where one ends on another, that one ends too. So around each
  /// vertex the item right of one edge is the item left of the next.
  std::vector<Edge> edges;
  /// The vertices by definition, and with each coordinate rounded once. Two that are rounded alike
  /// are merged only if they are the same point.
  std::vector<MapPlace> places;
  std::vector<Point2> points;
  /// For each item 1 if it is an entirely visible convex polygon.
  std::vector<std::uint8_t> whole;
};

struct MapOptions {
  int threads = 1;  ///< the result does not depend on it
  /// Skips the sides of polygons whose visibility is known as a whole. Without it all sides are
  /// processed, for comparison.
  bool shortcuts = true;
};

VisibleMap visible_map(const Primitives& items, const MapOptions& options);

}  // namespace displayfile
