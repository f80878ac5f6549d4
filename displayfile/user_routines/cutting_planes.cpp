#include "clip/cutting_planes.h"

#include <array>
#include <cstdint>

#include "clip/round_to_nearest.h"
#include "displayfile/gouraud.h"
#include "displayfile/graphics_system.h"

namespace displayfile {

void GraphicsSystem::set_cutting_plane(int n, double a, double b, double c, double d) {
  const RoundToNearest nearest;
  cutting_planes_.set(n, a, b, c, d);
  record("set-cutting-plane", {n, a, b, c, d});
}

void GraphicsSystem::set_cutting_plane_off(int n) {
  cutting_planes_.set_off(n);
  record("set-cutting-plane", {n, false});
}

/// What the cutting planes leave of a polygon. A triangle whose normals differ stays one, or
/// becomes several about its first vertex, with invisible diagonals: normals are interpolated over
/// triangles. A polygon that no plane cuts is what it is without them; what is left of others
/// counts as entered in world coordinates.
void GraphicsSystem::enter_cut(const WorldPolygon& polygon) {
  if (!cutting_planes_.cut_some(polygon.vertices)) return enter_whole(polygon);
  const CutPolygon cut =
      cutting_planes_.cut(polygon.vertices, polygon.edge_visible, polygon.vertex_normals);
  const auto& vertices = cut.vertices;
  const auto& edge_visible = cut.edge_visible;
  const auto& normals = cut.normals;
  if (vertices.empty()) return;
  if (vertices.size() == 3 || !differ(normals)) {
    return enter_whole({vertices, edge_visible, polygon.normal, normals, polygon.pick});
  }
  const std::size_t last = vertices.size() - 1;
  const auto is_drawn = [&](std::size_t k) {
    return edge_visible.empty() ? std::uint8_t{1} : edge_visible[k];
  };
  for (std::size_t k = 1; k < last; ++k) {
    const std::array corners{vertices[0], vertices[k], vertices[k + 1]};
    const std::array of_corners{normals[0], normals[k], normals[k + 1]};
    const std::array drawn{k + 1 == last ? is_drawn(0) : std::uint8_t{0},
                           k == 1 ? is_drawn(1) : std::uint8_t{0}, is_drawn(k + 1)};
    enter_whole({corners, drawn, polygon.normal, of_corners, polygon.pick});
  }
}

}  // namespace displayfile
