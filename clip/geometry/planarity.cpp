#include "clip/geometry/planarity.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "clip/geometry/back_face.h"

namespace displayfile {

bool is_flat(std::span<const Point3> world) {
  if (world.size() <= 3) return true;
  Point3 low = world.front(), high = world.front(), mean(0.0);
  for (const Point3& p : world) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const Point3 extent = high - low;
  const double size = std::max({extent.x, extent.y, extent.z});
  if (size == 0.0) return true;
  for (const Point3& p : world) mean += (p - low) / size;
  mean /= static_cast<double>(world.size());
  Point3 normal = newell_normal(world) / size / size;
  const double length = std::sqrt(glm::dot(normal, normal));
  if (length == 0.0) return true;
  normal /= length;
  return std::ranges::all_of(world, [&](const Point3& p) {
    return std::abs(glm::dot((p - low) / size - mean, normal)) <= kFlatnessTolerance;
  });
}

}  // namespace displayfile
