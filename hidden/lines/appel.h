#pragma once

#include <cstddef>

#include "hidden/lines/line_table.h"

namespace displayfile {

/// How the counts at the lines' starts were found: number of lines.
struct AppelCounts {
  std::size_t rays = 0;     ///< by comparison with all polygons in front of a point
  std::size_t carried = 0;  ///< from a connected line
  std::size_t contour_edges = 0;
};

/// The visible pieces by Appel's method (hidden/lines/appel.md): quantitative invisibility, carried
/// along connected lines.
SeenLines visible_lines_by_appel(const Primitives& items, const LineTable& scene,
                                 const SurfacePlan& plan, AppelCounts* counts = nullptr);

/// The same by the plain form (hidden/lines/plain_appel.h), in one thread except for the contour
/// edges.
SeenLines visible_lines_by_plain_appel(const Primitives& items, const LineTable& scene,
                                       const SurfacePlan& plan);

}  // namespace displayfile
