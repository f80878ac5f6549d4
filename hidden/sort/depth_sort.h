#pragma once

#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// Depth sort (the lecture's, with the problem book's priority tests) at the precision of the
/// plan: what must be drawn before what, over the pairs that overlap in the projection, and
/// cuts only where polygons go through each other or overlap in a cycle
/// (hidden/sort/depth_sort.md).
SortedPieces sort_by_depth(const Primitives& items, const SurfacePlan& plan);

}  // namespace displayfile
