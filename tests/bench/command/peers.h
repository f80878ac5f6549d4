#pragma once

#include <vector>

#include "tests/bench/command/contenders.h"

namespace displayfile::bench {

/// Those of other makers that this build and system have: OSMesa at each of its depth formats,
/// Embree and gl2ps. They get fills, cut into triangles; neither lines nor shades but for OSMesa.
std::vector<Contender> peers();

}  // namespace displayfile::bench
