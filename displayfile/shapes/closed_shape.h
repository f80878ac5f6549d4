#pragma once

#include <cstdint>
#include <vector>

#include "displayfile/graphics_system.h"

namespace displayfile {

/// A closed solid as polygons that share vertices, in the coordinates of the application: each
/// counterclockwise seen from outside, and each edge used once in either direction.
struct ClosedShape {
  std::vector<Point3> vertices;        ///< also those that no polygon uses
  std::vector<std::uint32_t> corners;  ///< indices into vertices, polygon after polygon
  std::vector<std::uint32_t> sides;    ///< of each polygon
  /// One for each corner, of length 1, where the solid stands for a curved one; zero at the corners
  /// of a polygon that is flat. Empty if all are.
  std::vector<Point3> normals;

  void add(std::initializer_list<std::uint32_t> polygon) {
    corners.insert(corners.end(), polygon);
    sides.push_back(static_cast<std::uint32_t>(polygon.size()));
  }
};

/// Enters a solid's polygons, as GraphicsSystem::polygons_abs_3 does, counterclockwise from outside
/// in world coordinates too, where the modelling transformation mirrors. Where there is light and
/// shading is smooth, with the normals of their vertices: those of what the solid stands for.
/// Errors, before any polygon is entered: no segment open, those of coordinates, normals that
/// set_vertex_normals has set (not with normals of its own, which take their place).
void enter(GraphicsSystem& system, const ClosedShape& solid);

}  // namespace displayfile
