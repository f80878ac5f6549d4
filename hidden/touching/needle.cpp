#include "hidden/touching/needle.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "clip/geometry/unit.h"
#include "clip/point.h"

namespace displayfile {

namespace {

const Point3& farthest_from(const Point3& from, const PointRow& polygon) {
  const Point3* farthest = &from;
  double most = 0.0;
  for (const Point3& p : polygon) {
    const double distance = glm::distance(from, p);
    if (distance > most) most = distance, farthest = &p;
  }
  return *farthest;
}

}  // namespace

bool is_within_reach_of_line(const PointRow& polygon, double reach) {
  const Point3& from = farthest_from(polygon[0], polygon);
  const Point3& to = farthest_from(from, polygon);
  if (from == to) return true;
  const Point3 direction = unit(to - from);
  return std::ranges::all_of(polygon, [&](const Point3& p) {
    const Point3 off = p - from;
    return glm::distance(off, glm::dot(off, direction) * direction) <= reach;
  });
}

}  // namespace displayfile
