#pragma once

#include <vector>

#include "tests/bench/command/contenders.h"

namespace displayfile::bench {

/// The contenders of other projects that this build and system have: OSMesa at each of its depth
/// formats, Embree and gl2ps. They get fills, cut into triangles; only OSMesa also gets lines and
/// shades.
std::vector<Contender> peers();

}  // namespace displayfile::bench
