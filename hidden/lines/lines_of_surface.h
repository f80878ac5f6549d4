#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hidden/lines/grid_surface.h"
#include "hidden/lines/visible_lines.h"

namespace displayfile {

/// Adds the drawn lines of a surface's cells, as in lines_to_draw. The grid determines which cells
/// share sides, and no other sides have the same ends, so that no table of sides is needed. The
/// surface is of the items; `picks` are their pick identifiers, or none.
void add_lines_of(const GridSurface& surface, const Primitives& items,
                  std::span<const std::int32_t> picks, std::vector<LineToDraw>& lines);

}  // namespace displayfile
