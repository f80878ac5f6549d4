#pragma once

#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// Depth sort (the lecture's, with the problem book's priority tests) at the precision of the plan:
/// a drawing order over the pairs that overlap in the projection, with cuts only where polygons
/// intersect or overlap in a cycle (hidden/sort/depth_sort.md).
SortedPieces sort_by_depth(const Primitives& items, const SurfacePlan& plan);

}  // namespace displayfile
