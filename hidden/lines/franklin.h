#pragma once

#include "hidden/lines/line_table.h"

namespace displayfile {

/// The visible pieces by Franklin's method (hidden/lines/franklin.md): a grid of cells, in which a
/// line is compared with nearby polygons that are not behind a blocking face. The recommended
/// method.
SeenLines visible_lines_by_franklin(const Primitives& items, const LineTable& scene,
                                    const SurfacePlan& plan);

}  // namespace displayfile
