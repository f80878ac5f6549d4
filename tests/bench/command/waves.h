#pragma once

#include <cstddef>
#include <cstdint>

#include "displayfile/graphics_system.h"

namespace displayfile::bench {

/// Enters a surface over a grid, of about n triangles (no more, but two at least), by one call of
/// surface_3, so that methods which need a surface recognise it: waves that run in directions and
/// from phases of the seed, in perspective, from above and aside. Solid, and no side is drawn as a
/// line.
void enter_waves(std::size_t n, std::uint64_t seed, GraphicsSystem& system);

}  // namespace displayfile::bench
