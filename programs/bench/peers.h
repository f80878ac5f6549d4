#pragma once

#include <vector>

#include "programs/bench/contenders.h"

namespace displayfile::bench {

/// Those of other makers that this build has beside OSMesa: Embree and gl2ps. They draw fills, cut
/// into triangles, and neither lines nor shades.
std::vector<Contender> peers();

}  // namespace displayfile::bench
