#pragma once

#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The textbook's sort (algorithms 9.8 to 9.16) at the precision of the plan: a tree of polygons,
/// each node's plane separates its front from its back (hidden/sort/bsp.md).
SortedPieces sort_by_bsp(const Primitives& items, const SurfacePlan& plan);

/// The same by the textbook's tree (hidden/sort/plain_bsp.h), without choosing roots.
SortedPieces sort_by_plain_bsp(const Primitives& items, const SurfacePlan& plan);

}  // namespace displayfile
