#pragma once

#include <cstdint>
#include <glm/mat4x3.hpp>
#include <span>

#include "clip/geometry/point_row.h"
#include "clip/point.h"

namespace displayfile {

/// A polygon in world coordinates.
struct WorldPolygon {
  PointRow vertices;
  std::span<const std::uint8_t> edge_visible;  ///< of the side that ends at the vertex; empty: all
  Point3 normal;  ///< Newell's normal of the whole polygon, where there is light
  std::span<const Point3> vertex_normals;  ///< with smooth shading and light
  std::int32_t pick;
  /// The vertices as entered, before the modelling transformation of that matrix. Null: the
  /// vertices are as entered.
  PointRow entered = std::span<const Point3>();
  const glm::dmat4x3* modelling = nullptr;
  bool is_cut = false;  ///< cut by cutting planes
};

}  // namespace displayfile
