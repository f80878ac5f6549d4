#include "displayfile/shared_planes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "displayfile/polygons_as_entered.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

namespace {

/// Three points of a polygon's plane; kOwnPlane if it has none.
Primitives::PlanePoints plane_points(const RetainedScene& scene, std::uint32_t primitive) {
  Primitives::PlanePoints points{Primitives::kOwnPlane, 0, 0};
  const PointRow polygon = scene.points(primitive);
  const auto [index, in_line] = spread_vertices({polygon.data(), polygon.size()});
  if (in_line) return points;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t corner = scene[primitive].first + index[k];
    points[k] = scene.has_shared() ? scene.corners(primitive)[index[k]] : corner;
  }
  return points;
}

}  // namespace

std::vector<Primitives::PlanePoints> shared_planes(const RetainedScene& scene) {
  PolygonsAsEntered polygons;
  polygons.add(scene);
  const TouchingPlanes touching = polygons.planes();
  if (touching.touching() == 0) return {};
  constexpr Primitives::PlanePoints kAlone{Primitives::kOwnPlane, 0, 0};
  std::vector<Primitives::PlanePoints> planes(scene.size(), kAlone);
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    const std::uint32_t of = touching.plane_of(i);
    if (of == i) continue;
    if (planes[of] == kAlone) planes[of] = plane_points(scene, of);
    planes[i] = planes[of];
  }
  return planes;
}

}  // namespace displayfile
