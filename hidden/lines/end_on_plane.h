#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "clip/point.h"
#include "hidden/exact/plane.h"
#include "hidden/lines/line_precision.h"

namespace displayfile {

/// The plane's depth, which is not edge-on, rounded.
inline double depth_in_doubles(const Plane& plane, const Point2& at) {
  const Point3& n = plane.normal;
  return plane.p.z - (n.x * (at.x - plane.p.x) + n.y * (at.y - plane.p.y)) / n.z;
}

/// True if the end v of a line counts as lying on the plane through p, q and r, which is not
/// edge-on: judged in doubles, in the display file's coordinates. As entered v is on the plane, but
/// viewing has moved each of the four points by up to `off` in each coordinate. So v may be off the
/// plane by its own error, and by those of p, q and r in the shares that they have in it, which are
/// large far away from them.
inline bool is_end_on_plane(const Point3& v, const Point3& p, const Point3& q, const Point3& r,
                            double off) {
  constexpr double kLargestShares = 0x1p20;  // of points so far away nothing can be told
  const Point3 normal = glm::cross(q - p, r - p);
  const auto area = [](const Point3& a, const Point3& b, const Point3& c) {
    return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  };
  const double shares = (area(v, q, r) + area(p, v, r) + area(p, q, v)) / std::abs(normal.z);
  const double per_coordinate = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  return shares <= kLargestShares &&
         std::abs(glm::dot(normal, v - p)) <= off * (1.0 + shares) * per_coordinate;
}

/// True if both ends of a line, at the line's depths, are on the plane but for what viewing rounds:
/// then it lies in it. An intersection lies in the planes of its own polygons alone.
inline bool lies_in_plane(const DepthLine& line, const Plane& plane, double off) {
  if (!(off > 0.0) || line.common != nullptr) return false;
  const auto is_on_plane = [&](Point3 end) {
    if (line.plane != nullptr) end.z = depth_in_doubles(*line.plane, Point2(end));
    return is_end_on_plane(end, plane.p, plane.q, plane.r, off);
  };
  return is_on_plane(line.a) && is_on_plane(line.b);
}

}  // namespace displayfile
