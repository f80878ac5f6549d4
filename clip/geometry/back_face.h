#pragma once

#include <span>

#include "clip/point.h"

namespace displayfile {

/// A normal of the polygon, by Newell's sums (equation 9.3): its components are twice the areas of
/// the polygon's projections along x, y and z. Computed relative to the first vertex, which does
/// not change the sums but avoids cancellation for small polygons far from the origin. Points out
/// of the light face: the one from which the vertices run counterclockwise. Reversing the vertices
/// negates it, up to rounding.
inline Point3 newell_normal(std::span<const Point3> vertices) {
  Point3 sum(0.0);
  if (vertices.empty()) return sum;
  const Point3 origin = vertices.front();
  Point3 p = vertices.back() - origin;
  for (const Point3& vertex : vertices) {
    const Point3 q = vertex - origin;
    sum.x += (p.y - q.y) * (p.z + q.z);
    sum.y += (p.z - q.z) * (p.x + q.x);
    sum.z += (p.x - q.x) * (p.y + q.y);
    p = q;
  }
  return sum;
}

/// The z component of newell_normal alone.
inline double newell_c(std::span<const Point3> vertices) {
  double c = 0.0;
  if (vertices.empty()) return c;
  const Point3 origin = vertices.front();
  double px = vertices.back().x - origin.x, py = vertices.back().y - origin.y;
  for (const Point3& vertex : vertices) {
    const double qx = vertex.x - origin.x, qy = vertex.y - origin.y;
    c += (px - qx) * (py + qy);
    px = qx;
    py = qy;
  }
  return c;
}

/// BACK-FACE-CHECK (algorithm 9.3): true if the polygon, in device coordinates, turns its
/// dark face or its edge to the viewer.
inline bool is_back_face(std::span<const Point3> vertices) { return newell_c(vertices) <= 0.0; }

}  // namespace displayfile
