#pragma once

#include <cstdint>
#include <vector>

#include "displayfile/graphics_system.h"

namespace displayfile {

/// A closed solid as polygons that share vertices, in the application's coordinates:
/// counterclockwise seen from outside, with each edge used once in each direction.
struct ClosedShape {
  std::vector<Point3> vertices;        ///< including unused ones
  std::vector<std::uint32_t> corners;  ///< indices into vertices, polygon after polygon
  std::vector<std::uint32_t> sides;    ///< of each polygon
  /// One per corner, of length 1, where the solid approximates a curved one; zero at the corners of
  /// planar polygons. Empty if all are zero.
  std::vector<Point3> normals;

  void add(std::initializer_list<std::uint32_t> polygon) {
    corners.insert(corners.end(), polygon);
    sides.push_back(static_cast<std::uint32_t>(polygon.size()));
  }
};

/// Enters a solid's polygons as GraphicsSystem::polygons_abs_3 does, counterclockwise from outside
/// in world coordinates even where the modelling transformation mirrors; with vertex normals of the
/// approximated solid where there is light and smooth shading. Errors, before any polygon is
/// entered: no segment open; those of coordinates; normals set by set_vertex_normals (except for a
/// solid with normals, which replace them).
void enter(GraphicsSystem& system, const ClosedShape& solid);

}  // namespace displayfile
