#include "displayfile/entered/intensity_plane.h"

#include <cassert>
#include <cmath>

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

}  // namespace displayfile
