#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "hidden/lines/cell_grid.h"
#include "hidden/lines/contour_edges.h"
#include "hidden/lines/line_table.h"
#include "hidden/lines/side_table.h"
#include "hidden/map/map_place.h"
#include "hidden/map/seen_faces.h"

namespace displayfile {

/// What the edges of a map are found from.
struct MapTable {
  const Primitives& items;
  const LineTable& lines;  ///< the polygons; it has no lines
  const SideTable& sides;
  const CellGrid& grid;
  const SeenFaces& faces;
};

/// A part of a line with one item seen left of it and another right of it, going from `from` to
/// `to`; LineTable::kNone where nothing is seen.
struct MapEdge {
  MapPlace from, to;
  Point2 at_from, at_to;  ///< the places rounded once
  std::uint32_t left, right;
  bool goes_on = false;  ///< it goes on along the line of the edge before it, with the same items
};

/// The edges that lie on sides of what is seen beside them.
std::vector<MapEdge> edges_on_sides(const MapTable& map, const ContourEdges& ways, int threads);

/// The edges where what is seen beside them passes through each other.
std::vector<MapEdge> edges_of_meetings(const MapTable& map, int threads);

}  // namespace displayfile
