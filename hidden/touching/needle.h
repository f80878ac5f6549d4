#pragma once

#include "clip/geometry/point_row.h"

namespace displayfile {

/// True if no corner of a polygon is farther than reach from the line through two that are far
/// apart: a needle, as Booleans and triangulation leave along seams. Its normal depends on rounding
/// alone, so the polygons around it count as meeting at its place. Any coordinate system, in
/// doubles.
bool is_within_reach_of_line(const PointRow& polygon, double reach);

}  // namespace displayfile
