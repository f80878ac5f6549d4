#include "hidden/lines/far_planes.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "clip/base/parallel.h"
#include "clip/geometry/bounds.h"

namespace displayfile {

FarPlanes::FarPlanes(const LineTable& scene, int threads) {
  constexpr double kRounding = 0x1p-48;  // a generous bound for a sum of four products
  if (!(scene.touching() > 0.0)) return;
  const double largest = largest_coordinate(scene.points());
  planes_.resize(scene.items());
  in_even_parts(scene.items(), threads, [&](std::uint32_t i) {
    if (!scene.hides(i) || scene.has_rests(i)) return;
    const Plane plane = scene.plane(i);
    const double touching =
        scene.touching() * (1.0 + scene.most_shares() / std::abs(plane.normal.z)) * plane.reach;
    const double of_normal = plane.bound.x + plane.bound.y + plane.bound.z;
    planes_[i] = {
        plane.normal, glm::dot(plane.normal, plane.p),
        (1.0 + 0x1p-20) * touching + 2.0 * largest * (of_normal + kRounding * plane.reach) + kTiny};
  });
}

}  // namespace displayfile
