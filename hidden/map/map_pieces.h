#pragma once

#include "hidden/map/visible_map.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The map as polygons without holes, in order of items: the visible parts of each, which do not
/// overlap. A part's outline includes each map vertex on it, so that its neighbours have the same;
/// holes are joined to it by sides traversed twice. No sides are visible. An entirely visible
/// polygon with no divided or drawn side is referred to as a whole.
///
/// A point's z is that of the polygon's plane there, or the corner's own. Pieces without area after
/// rounding are omitted.
SortedPieces pieces_of_map(const Primitives& items, const VisibleMap& map);

}  // namespace displayfile
