#pragma once

#include "hidden/lines/line_table.h"

namespace displayfile {

/// The visible pieces by Roberts's method (hidden/lines/roberts.md): each line against each polygon
/// that may hide it. The plain form, and the reference of the others.
SeenLines visible_lines_by_roberts(const Primitives& items, const LineTable& scene,
                                   const SurfacePlan& plan);

}  // namespace displayfile
