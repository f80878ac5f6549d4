#include "hidden/support_plane.h"

#include <cmath>

#include "hidden/orientation.h"

namespace displayfile {

SupportVertices support_vertices(std::span<const Point3> v) {
  if (v.size() < 3) return {{0, 0, 0}, true};
  const auto twice_area = [&](std::size_t q, std::size_t i) {
    return std::abs((v[q].x - v[0].x) * (v[i].y - v[0].y) - (v[q].y - v[0].y) * (v[i].x - v[0].x));
  };
  // In doubles, as the definition says; but three points that are in line although that value is
  // not 0 have no plane either.
  const auto in_line = [&](std::size_t q, std::size_t r) {
    return twice_area(q, r) == 0.0 || orientation(v[0], v[q], v[r]) == 0;
  };
  if (v.size() == 3) return {{0, 1, 2}, in_line(1, 2)};
  std::size_t q = 0, r = 0;
  double farthest = -1.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double dx = v[i].x - v[0].x, dy = v[i].y - v[0].y;
    if (const double d = dx * dx + dy * dy; d > farthest) {
      farthest = d;
      q = i;
    }
  }
  farthest = -1.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (const double d = twice_area(q, i); d > farthest) {
      farthest = d;
      r = i;
    }
  }
  return {{0, static_cast<std::uint32_t>(q), static_cast<std::uint32_t>(r)}, in_line(q, r)};
}

DepthPlane depth_plane(const Point3& p, const Point3& q, const Point3& r) {
  const Point3 u = q - p, v = r - p;
  const double c = u.x * v.y - u.y * v.x;
  return {p.x, p.y, p.z, (u.z * v.y - u.y * v.z) / c, (u.x * v.z - u.z * v.x) / c};
}

}  // namespace displayfile
