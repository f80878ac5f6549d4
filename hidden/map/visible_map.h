#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "hidden/map/map_place.h"
#include "hidden/primitives.h"

namespace displayfile {

/// Which item is seen at each point of the projection: the plane divided by edges, beside each of
/// which one item is seen on the left and another on the right (hidden/map/visible_map.md). Device
/// coordinates.
///
/// Among the solid polygons that cover a point, the one is seen whose plane is nearest there, and
/// among several in one plane the one entered last. Edge-on polygons, hollow ones and lines are not
/// part of it.
struct VisibleMap {
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

  /// From one vertex to another, which differ; what is seen beside it, kNothing for the background.
  struct Edge {
    std::uint32_t from, to;
    std::uint32_t left, right;
  };
  /// Edges have no points in common but vertices: where one ends on another, that one ends too. So
  /// around each vertex what is seen right of one edge is seen left of the next.
  std::vector<Edge> edges;
  /// The vertices as what they are, and each coordinate rounded once. Two that are rounded alike
  /// are one only if they are one point.
  std::vector<MapPlace> places;
  std::vector<Point2> points;
  /// For each item 1 if all of it is seen, a convex polygon.
  std::vector<std::uint8_t> whole;
};

struct MapOptions {
  int threads = 1;  ///< the result is the same for any number
  /// What is known of whole polygons spares looking at their sides. Without it all is found side by
  /// side, to compare with.
  bool shortcuts = true;
};

VisibleMap visible_map(const Primitives& items, const MapOptions& options);

}  // namespace displayfile
