#include "displayfile/entered/normal_plane.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>

#include "clip/geometry/corners.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

IntensityPlane::IntensityPlane(std::span<const Point3> device,
                               std::span<const double> intensities) {
  assert(!intensities.empty() && device.size() == intensities.size());
  low = *std::ranges::min_element(intensities);
  high = *std::ranges::max_element(intensities);
  const SupportVertices support = support_vertices(device);
  i0 = mean_intensity(intensities);
  if (support.edge_on) return;
  const auto point = [&](std::size_t k) {
    const auto vertex = support.index[k];
    return Point3(Point2(device[vertex]), intensities[vertex]);
  };
  const DepthPlane plane = depth_plane(point(0), point(1), point(2));
  if (!std::isfinite(plane.dz_dx) || !std::isfinite(plane.dz_dy)) return;
  x0 = plane.x0;
  y0 = plane.y0;
  i0 = plane.z0;
  di_dx = plane.dz_dx;
  di_dy = plane.dz_dy;
}

NormalPlane::NormalPlane(std::span<const Point3> device, std::span<const Point3> normals)
    : low(normals.front()), high(normals.front()) {
  assert(device.size() == normals.size());
  for (const Point3& n : normals) {
    low = glm::min(low, n);
    high = glm::max(high, n);
  }
  n0 = mean_of_vertices(normals);
  const SupportVertices support = support_vertices(device);
  if (support.edge_on) return;
  NormalPlane through = *this;
  for (int component = 0; component < 3; ++component) {
    const auto point = [&](std::size_t k) {
      const auto vertex = support.index[k];
      return Point3(Point2(device[vertex]), normals[vertex][component]);
    };
    const DepthPlane plane = depth_plane(point(0), point(1), point(2));
    if (!std::isfinite(plane.dz_dx) || !std::isfinite(plane.dz_dy)) return;
    through.x0 = plane.x0;
    through.y0 = plane.y0;
    through.n0[component] = plane.z0;
    through.dn_dx[component] = plane.dz_dx;
    through.dn_dy[component] = plane.dz_dy;
  }
  *this = through;
}

Point3 NormalPlane::within(const Point3& normal, const Point3& low, const Point3& high) {
  Point3 kept;
  for (int c = 0; c < 3; ++c) {
    kept[c] = normal[c] > low[c] ? std::min(normal[c], high[c]) : low[c];  // low for NaN too
  }
  return kept;
}

}  // namespace displayfile
