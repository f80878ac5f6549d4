#pragma once

#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/triangles/ear_cutting.h"

namespace displayfile {

/// Appends triangles that tile a polygon of at least three corners, in n log n
/// (hidden/triangles/triangulation.md): two fewer than its corners, none with the opposite
/// orientation, each of its sides a side of one of them. Signs are exact. Triangles without area
/// are made only where the polygon repeats a point or touches itself. False, appending nothing, if
/// the polygon crosses itself, or touches itself in a way that the sweep does not resolve. (Hertel
/// and Mehlhorn, Fast triangulation of simple polygons, 1983.)
bool sweep_triangles(std::span<const Point2> polygon, std::vector<CornerTriple>& triangles);

}  // namespace displayfile
