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

/// Input for finding the edges of a map.
struct MapTable {
  const Primitives& items;
  const LineTable& lines;  ///< the polygons; it has no lines
  const SideTable& sides;
  const CellGrid& grid;
  const SeenFaces& faces;
};

/// A part of a line, from `from` to `to`, with the items visible on its left and right;
/// LineTable::kNone for none.
struct MapEdge {
  MapPlace from, to;
  Point2 at_from, at_to;  ///< the places rounded once
  std::uint32_t left, right;
  bool goes_on = false;  ///< continues the edge before it on the same line, with the same items
};

/// The edges that lie on sides of polygons visible beside them.
std::vector<MapEdge> edges_on_sides(const MapTable& map, const ContourEdges& ways, int threads);

/// The edges where the polygons visible beside them intersect.
std::vector<MapEdge> edges_of_meetings(const MapTable& map, int threads);

}  // namespace displayfile
