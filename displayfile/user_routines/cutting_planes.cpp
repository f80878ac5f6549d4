#include "clip/pipeline/cutting_planes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>

#include "clip/base/round_to_nearest.h"
#include "displayfile/looks/gouraud.h"
#include "displayfile/user_routines/system_state.h"

namespace displayfile {

void GraphicsSystem::set_cutting_plane(int n, double a, double b, double c, double d) {
  const RoundToNearest nearest;
  state_->cutting_planes_.set(n, a, b, c, d);
  state_->plane_uses_.set(n, {a, b, c, d});
  state_->record("set-cutting-plane", {n, a, b, c, d});
}

void GraphicsSystem::set_cutting_plane_off(int n) {
  state_->cutting_planes_.set_off(n);
  state_->plane_uses_.set_off(n);
  state_->record("set-cutting-plane", {n, false});
}

/// Points within reach of a plane lie in it, as those within reach of a polygon's plane do.
void GraphicsSystem::State::set_reach_of_planes() {
  const Touching& touching = surfaces_.touching;
  CuttingPlanes::Reach reach;
  if (touching.kind == Touching::Kind::automatic) {
    reach.of_terms = entered_reach(touching, 1.0);
  } else {
    reach.length = entered_reach(touching, 0.0);
    if (const glm::dmat4x3* const modelling = modelling_matrix()) {
      reach.length *= std::max({glm::length((*modelling)[0]), glm::length((*modelling)[1]),
                                glm::length((*modelling)[2])});
    }
  }
  cutting_planes_.set_reach(reach);
}

void GraphicsSystem::State::as_faces_of_solid(double volume, const std::function<void()>& enter) {
  const double before = std::exchange(volume_of_faces_, volume);
  try {
    enter();
  } catch (...) {
    volume_of_faces_ = before;
    throw;
  }
  volume_of_faces_ = before;
}

/// Enters the part of a polygon that the cutting planes leave. A triangle whose normals differ
/// stays one, or becomes several about its first vertex, with invisible diagonals: normals are
/// interpolated over triangles. A polygon that no plane cuts is entered as without planes; the
/// points where others are cut count as entered, under the same modelling transformation.
void GraphicsSystem::State::enter_cut(const WorldPolygon& polygon) {
  if (is_face_of_cut_away(polygon.vertices)) return;
  if (!are_cut(polygon.vertices)) return enter_whole(polygon);
  const CutPolygon cut = cutting_planes_.cut(
      polygon.vertices.row(), polygon.edge_visible, polygon.vertex_normals,
      polygon.modelling == nullptr ? std::span<const Point3>() : polygon.entered.row());
  const auto& vertices = cut.vertices;
  const auto& edge_visible = cut.edge_visible;
  const auto& normals = cut.normals;
  const auto& entered = cut.entered;
  if (vertices.empty()) return;
  if (vertices.size() == 3 || !differ(normals)) {
    return enter_whole({vertices, edge_visible, polygon.normal, normals, polygon.pick, entered,
                        polygon.modelling, true});
  }
  const std::size_t last = vertices.size() - 1;
  const auto is_drawn = [&](std::size_t k) {
    return edge_visible.empty() ? std::uint8_t{1} : edge_visible[k];
  };
  for (std::size_t k = 1; k < last; ++k) {
    const auto of_triangle = [k](std::span<const Point3> all) {
      return std::array{all[0], all[k], all[k + 1]};
    };
    const std::array corners = of_triangle(vertices), of_corners = of_triangle(normals);
    const std::array as_entered = entered.empty() ? corners : of_triangle(entered);
    const std::array drawn{k + 1 == last ? is_drawn(0) : std::uint8_t{0},
                           k == 1 ? is_drawn(1) : std::uint8_t{0}, is_drawn(k + 1)};
    enter_whole({corners, drawn, polygon.normal, of_corners, polygon.pick, as_entered,
                 polygon.modelling, true});
  }
}

}  // namespace displayfile
