#pragma once

#include <span>

#include "hidden/lines/visible_lines.h"

namespace displayfile {

/// The visible pieces of a surface's curves by the perimeter method (hidden/lines/perimeter.md).
/// Lines that are not the surface's, and curves that run along its verticals, are looked at by
/// Franklin's. With exact precision the pieces are those of the other methods of lines, but for
/// crumbs where sides run along a vertical; with ROUNDOFF those of an array of minima and maxima
/// (perimeter_array.h). Names are in order, each once. Throws Error if the polygons are not one
/// whole surface (grid_surface.h), and if there are intersections.
/// `known` is that surface, or null.
SeenLines visible_lines_by_perimeter(const Primitives& items, std::span<const LineName> names,
                                     const SurfacePlan& plan,
                                     std::span<const IntersectionLine> intersections,
                                     const GridSurface* known);

}  // namespace displayfile
