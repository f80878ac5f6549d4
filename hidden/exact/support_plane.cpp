#include "hidden/exact/support_plane.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "hidden/exact/orientation.h"

namespace displayfile {

namespace {

/// True if the points are collinear in space, exactly.
bool in_line(const Point3& p, const Point3& q, const Point3& r) {
  const auto in_projection = [&](int x, int y) {
    return orientation(Point2(p[x], p[y]), Point2(q[x], q[y]), Point2(r[x], r[y])) == 0;
  };
  return in_projection(0, 1) && in_projection(1, 2) && in_projection(2, 0);
}

}  // namespace

SupportVertices support_vertices(std::span<const Point3> v) {
  if (v.size() < 3) return {{0, 0, 0}, true};
  const auto twice_area = [&](std::size_t q, std::size_t i) {
    return std::abs((v[q].x - v[0].x) * (v[i].y - v[0].y) - (v[q].y - v[0].y) * (v[i].x - v[0].x));
  };
  const auto in_line = [&](std::size_t q, std::size_t r) {
    return orientation(v[0], v[q], v[r]) == 0;
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
  // Points collinear by doubles may be off the line exactly.
  for (std::size_t i = 0; in_line(q, r) && i < v.size(); ++i) {
    if (!in_line(q, i)) r = i;
  }
  const bool edge_on = in_line(q, r);
  assert(edge_on || (q != 0 && r != 0 && q != r));
  return {{0, static_cast<std::uint32_t>(q), static_cast<std::uint32_t>(r)}, edge_on};
}

SupportVertices spread_vertices(std::span<const Point3> v) {
  const auto farthest = [&](const auto& measure) {
    std::uint32_t best = 0;
    double most = -1.0;
    for (std::uint32_t i = 0; i < v.size(); ++i) {
      if (const double size = measure(v[i]); size > most) {
        most = size;
        best = i;
      }
    }
    return best;
  };
  if (v.size() < 3) return {{0, 0, 0}, true};
  const std::uint32_t q = farthest([&](const Point3& p) { return glm::dot(p - v[0], p - v[0]); });
  const auto off_line = [&](const Point3& p) {
    const Point3 across = glm::cross(v[q] - v[0], p - v[0]);
    return glm::dot(across, across);
  };
  const std::uint32_t r = farthest(off_line);
  if (!in_line(v[0], v[q], v[r])) return {{0, q, r}, false};
  for (std::uint32_t i = 0; i < v.size(); ++i) {  // the measure may have underflowed
    if (!in_line(v[0], v[q], v[i])) return {{0, q, i}, false};
  }
  return {{0, q, r}, true};
}

DepthPlane depth_plane(const Point3& p, const Point3& q, const Point3& r) {
  const Point3 u = q - p, v = r - p;
  const double c = u.x * v.y - u.y * v.x;
  return {p.x, p.y, p.z, (u.z * v.y - u.y * v.z) / c, (u.x * v.z - u.z * v.x) / c};
}

}  // namespace displayfile
