#include "displayfile/views/shared_planes.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "displayfile/segments/polygons_as_entered.h"
#include "hidden/exact/entered_plane.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

std::optional<Primitives::PlanePoints> support_plane(const RetainedScene& scene,
                                                     std::uint32_t primitive) {
  const PointRow entered = scene.entered_points(primitive), world = scene.points(primitive);
  const auto support = support_of_entered({entered.data(), entered.size()});
  if (!support) return std::nullopt;
  const auto& [p, q, r] = *support;
  // Rounding may have put them in line.
  if (spread_vertices(std::array{world[p], world[q], world[r]}).edge_on) return std::nullopt;
  Primitives::PlanePoints points;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto corner = static_cast<std::uint32_t>((*support)[k]);
    points[k] =
        scene.has_shared() ? scene.corners(primitive)[corner] : scene[primitive].first + corner;
  }
  return points;
}

std::vector<Primitives::PlanePoints> shared_planes(const RetainedScene& scene) {
  PolygonsAsEntered polygons;
  polygons.add(scene);
  const TouchingPlanes touching = polygons.planes();
  if (touching.touching() == 0 && polygons.bent().empty()) return {};
  constexpr Primitives::PlanePoints kAlone{Primitives::kOwnPlane, 0, 0};
  std::vector<Primitives::PlanePoints> planes(scene.size(), kAlone);
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    const std::uint32_t of = touching.plane_of(i);
    if (of == i) continue;
    if (planes[of] == kAlone) planes[of] = support_plane(scene, of).value_or(kAlone);
    planes[i] = planes[of];
  }
  for (const std::uint32_t i : polygons.bent()) {
    if (planes[i] == kAlone) planes[i] = support_plane(scene, i).value_or(kAlone);
  }
  return planes;
}

}  // namespace displayfile
