#pragma once

// For the files that use CGAL only.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <cstdint>
#include <vector>

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

}  // namespace displayfile
