#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hidden/touching/touching_planes.h"

namespace displayfile {

/// Polygons that may touch.
struct MayTouch {
  /// Indices of two of `polygons`: the first may lie in the plane of the other.
  using Pair = TouchingPlanes::Pair;

  /// Ascending: all that lie within reach of another's support plane, or have another polygon
  /// within reach of theirs, and few others.
  std::vector<std::uint32_t> polygons;
  /// All of them, now and then one twice; nothing if there are too many.
  std::optional<std::vector<Pair>> pairs;
};

/// The polygons that may touch, at any size of the reach. Quick, in floats, by a grid over normals
/// and distances of planes (hidden/touching/touching_planes.md, "Which polygons may touch").
/// `reach` is in the polygons' coordinates, before modelling transformations, as in TouchingPlanes.
/// Nothing if that does not decide, if most polygons touch others, or if it would take about as
/// long as TouchingPlanes.
std::optional<MayTouch> planes_in_reach(std::uint32_t polygons,
                                        const TouchingPlanes::PolygonOf& polygon_of, double reach);

}  // namespace displayfile
