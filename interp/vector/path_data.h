#pragma once

#include <string>

#include "interp/vector/lattice_loops.h"

namespace displayfile {

/// Appends loops as the data of an SVG path, in few characters: relative whole numbers, `h` and `v`
/// where they are shorter; each loop begins where its longest side need not be written, and loops
/// follow each other from row to row.
void append_loops(std::string& out, const LatticeLoops& loops);

/// The same of chains, in their order and from their first vertices.
void append_chains(std::string& out, const LatticeChains& chains);

}  // namespace displayfile
