#pragma once

#include <string>

#include "interp/vector/lattice_loops.h"

namespace displayfile {

/// Appends loops as the data of an SVG path, in few characters: relative integers, `h` and `v`
/// where they are shorter; each loop begins so that its longest side need not be written, and loops
/// are ordered in rows.
void append_loops(std::string& out, const LatticeLoops& loops);

/// The same for chains, in order and from their first vertices.
void append_chains(std::string& out, const LatticeChains& chains);

}  // namespace displayfile
