#pragma once

#include "hidden/lines/line_scene.h"

namespace displayfile {

/// The visible pieces by Franklin's method (hidden/lines/franklin.md): a grid of cells, in which a
/// line is compared with what is near to it and not behind a blocking face. The method for use.
SeenLines visible_lines_by_franklin(const Primitives& items, const LineScene& scene,
                                    const LineOptions& options);

}  // namespace displayfile
