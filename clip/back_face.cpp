#include "clip/back_face.h"

namespace displayfile {

Point3 newell_normal(std::span<const Point3> vertices) {
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

bool is_back_face(std::span<const Point3> vertices) { return newell_c(vertices) <= 0.0; }

}  // namespace displayfile
