#pragma once

#include <cstddef>
#include <span>

#include "hidden/lines/line_table.h"
#include "hidden/lines/visible_lines.h"

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

/// The visible pieces by Roberts's method (hidden/lines/roberts.md): each line against each polygon
/// that may hide it. The plain form, and the reference of the others.
SeenLines visible_lines_by_roberts(const Primitives& items, const LineTable& scene,
                                   const SurfacePlan& plan);

/// The visible pieces by Franklin's method (hidden/lines/franklin.md): a grid of cells, in which a
/// line is compared with nearby polygons that are not behind a blocking face. The recommended
/// method.
SeenLines visible_lines_by_franklin(const Primitives& items, const LineTable& scene,
                                    const SurfacePlan& plan);

/// The visible pieces of a surface's curves by the perimeter method (hidden/lines/perimeter.md).
/// Other lines, and curves along its verticals, are found by Franklin's. With exact precision the
/// pieces are those of the other line methods, except for crumbs where sides run along a vertical;
/// with ROUNDOFF those of an array of minima and maxima (perimeter_array.h). Names are sorted and
/// unique. Throws Error if the polygons are not one whole surface (grid_surface.h), and if there
/// are intersection lines. `known` is that surface, or null.
SeenLines visible_lines_by_perimeter(const Primitives& items, std::span<const LineName> names,
                                     const SurfacePlan& plan,
                                     std::span<const IntersectionLine> intersections,
                                     const GridSurface* known);

}  // namespace displayfile
