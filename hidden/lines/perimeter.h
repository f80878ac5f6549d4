#pragma once

#include <span>

#include "hidden/lines/visible_lines.h"

namespace displayfile {

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
