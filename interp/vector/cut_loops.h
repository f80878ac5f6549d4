#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "interp/vector/lattice_loops.h"

namespace displayfile {

/// Vertices that cuts have put on sides, each but once: a side goes from one of its ends over this
/// vertex to the other, and so may its parts.
using VerticesOnSides = std::map<LatticeSide, LatticePoint>;

/// The loops in parts of at most `most` vertices each, 8 or more: disjoint, and together what the
/// loops cover. Each cut is along a column or a row of the lattice, through the middle of the
/// vertices, whichever crosses fewer sides. Where a side crosses it is a vertex afterwards, rounded
/// to the lattice: off the side by half a unit along an axis at most. Those are added to `put`, and
/// are to be put on the sides of all that shares them, these parts included: the sides of one cut
/// may be cut by the next. O(n log n) for each cut.
std::vector<LatticeLoops> parts_of(const LatticeLoops& loops, std::size_t most,
                                   VerticesOnSides& put);

/// Gives the loops the vertices that were put on their sides.
void put_vertices(LatticeLoops& loops, const VerticesOnSides& put);

}  // namespace displayfile
