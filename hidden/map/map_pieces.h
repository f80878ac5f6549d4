#pragma once

#include "hidden/map/visible_map.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The map as polygons without holes, in order of items: those parts of each that are seen, no two
/// of which overlap. A part's outline has each vertex of the map that it goes through, so that its
/// neighbours have the same; where it has holes, these are joined to it by sides that are gone
/// along twice. Of the sides none is visible. A polygon of which all is seen, no side of which is
/// divided or drawn, is named as a whole.
///
/// A point's z is that of the polygon's plane there, or the corner's own. What rounding the
/// vertices leaves without area is left out.
SortedPieces pieces_of_map(const Primitives& items, const VisibleMap& map);

}  // namespace displayfile
