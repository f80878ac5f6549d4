#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// A polygon counts as flat if no vertex lies farther from its plane than this times the
/// largest side of its bounding box. (Mesh files often hold single-precision coordinates.)
inline constexpr double kFlatnessTolerance = 1e-6;

/// True if the polygon (world coordinates) is flat within kFlatnessTolerance. A polygon
/// without area counts as flat. The plane goes through the vertices' mean, normal by Newell.
bool is_flat(std::span<const Point3> world);

/// Cuts polygons that are not flat into triangles.
class Triangulation {
 public:
  struct Triangle {
    std::array<std::uint32_t, 3> vertex;  ///< indices into the polygon
    std::array<std::uint8_t, 3>
        edge_visible;  ///< of the side that ends at that vertex; 0 for a diagonal
  };

  /// Triangles that tile the polygon, seen along its Newell normal, by cutting off ears; each
  /// keeps the polygon's own turning direction. A polygon that crosses itself has no such
  /// tiling; it is cut where ears are found and fanned from there. Quadratic in the number of
  /// sides for usual polygons. Valid until the next call.
  std::span<const Triangle> triangulate(std::span<const Point3> world);

 private:
  std::vector<Triangle> triangles_;
  struct Neighbours {
    std::uint32_t previous, next;
  };
  std::vector<Neighbours> ring_;  // of the vertices that are left
  std::vector<Point2> flattened_;
};

}  // namespace displayfile
