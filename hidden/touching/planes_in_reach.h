#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hidden/touching/touching_planes.h"

namespace displayfile {

/// The indices, ascending, of the polygons that may lie within reach of another's support plane, or
/// have another polygon within reach of theirs: all that do, and few others, at any size of the
/// reach. Quick, in doubles, by a grid over normals and distances of planes
/// (hidden/touching/touching_planes.md, "Which polygons may touch"). `reach` is in the polygons'
/// coordinates, before modelling transformations, as in TouchingPlanes. Nothing if doubles do not
/// decide, if most polygons touch others, or if it would take about as long as TouchingPlanes.
std::optional<std::vector<std::uint32_t>> planes_in_reach(
    std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of, double reach);

}  // namespace displayfile
