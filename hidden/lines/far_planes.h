#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "clip/point.h"
#include "hidden/lines/line_table.h"

namespace displayfile {

/// Detects in a few operations that a point is far from a polygon's plane, beyond the touching
/// distance by far more than rounding. Most polygons are far from each vertex of a mesh.
class FarPlanes {
 public:
  explicit FarPlanes(const LineTable& scene, int threads);

  /// For a point of the scene and the plane of one of its polygons. False if unknown.
  bool is_far(std::uint32_t item, const Point3& v) const {
    assert(item < planes_.size());
    const PlaneInDoubles& plane = planes_[item];
    const Point3& n = plane.normal;
    return std::abs(n.x * v.x + n.y * v.y + n.z * v.z - plane.offset) > plane.tolerance;
  }

 private:
  struct PlaneInDoubles {
    Point3 normal{0.0};
    double offset = 0.0;
    double tolerance = std::numeric_limits<double>::infinity();
  };
  std::vector<PlaneInDoubles> planes_;  // empty if nothing touches
};

}  // namespace displayfile
