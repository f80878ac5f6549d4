// For the files that use CGAL only.

#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <cstdint>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/solids/combining_steps.h"

namespace displayfile {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = ExactKernel::Point_3;

/// Triangles that bound a solid, counterclockwise from outside. Two of them share a side, share a
/// corner, or do not meet. The surface may touch itself: a side may be shared by four triangles or
/// more, and a corner by several fans of them. World coordinates.
struct ExactSurface {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<ExactPoint> points;      ///< with distinct positions
  std::vector<Triangle> triangles;     ///< indices into points
  std::vector<std::uint32_t> sources;  ///< the face of each triangle
};

/// Combines solids that may touch themselves and each other in any way, by the arrangement of their
/// triangles, without rounding. The result may touch itself, too. Coincident faces of both have a's
/// source in the result. Throws what `steps` throws.
///
/// Source: Zhou, Grinspun, Zorin, Jacobson, "Mesh arrangements for solid geometry", ACM
/// Transactions on Graphics 35 (4), 2016, with two solids and without rounding.
ExactSurface combined_by_arrangement(SolidOperation operation, const ExactSurface& a,
                                     const ExactSurface& b, CombiningSteps& steps);

}  // namespace displayfile
