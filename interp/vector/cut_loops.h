#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "interp/vector/lattice_loops.h"

namespace displayfile {

/// A vertex that cuts have added to a side, at most one for each: the side then runs from one end
/// through this vertex to the other, and its parts may have vertices in turn.
using VerticesOnSides = std::map<LatticeSide, LatticePoint>;

/// Splits the loops into parts of at most `most` vertices each, 8 or more: disjoint, with the loops
/// as their union. Each cut is along a column or a row of the lattice, through the median of the
/// vertices, whichever crosses fewer sides. Crossings become vertices, rounded to the lattice: off
/// the side by at most half a unit along an axis. They are added to `put`, and must be added to the
/// sides of all neighbours, including these parts: the sides of one cut may be cut by the next. O(n
/// log n) for each cut.
std::vector<LatticeLoops> parts_of(const LatticeLoops& loops, std::size_t most,
                                   VerticesOnSides& put);

/// Adds to the loops the vertices put on their sides.
void put_vertices(LatticeLoops& loops, const VerticesOnSides& put);

}  // namespace displayfile
