#include "hidden/exact/bent_polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hidden/exact/entered_plane.h"

namespace displayfile {

namespace {

/// In doubles, and false if they do not tell. The matrix makes a distance longer by less than twice
/// its longest column. The triple product is off by less than eight roundings of the sum of the
/// magnitudes that it adds up (Shewchuk's orient3d), and so is each coordinate of the normal.
bool is_certainly_flat(const PointRow& points, const std::array<std::size_t, 3>& support,
                       double largest) {
  constexpr double kRoundings = 0x1p-50;
  const Point3 first = points[support[0]];
  const Point3 a = points[support[1]] - first, b = points[support[2]] - first;
  const auto products = [&](int j, int k) { return std::array{a[j] * b[k], a[k] * b[j]}; };
  const std::array x = products(1, 2), y = products(2, 0), z = products(0, 1);
  const Point3 normal(x[0] - x[1], y[0] - y[1], z[0] - z[1]);
  const Point3 sizes(std::abs(x[0]) + std::abs(x[1]), std::abs(y[0]) + std::abs(y[1]),
                     std::abs(z[0]) + std::abs(z[1]));
  const auto greatest = [](const Point3& v) { return std::max({v.x, v.y, v.z}); };
  const double length = greatest(glm::abs(normal)) - kRoundings * greatest(sizes);
  const double most = 0.5 * kFlatAsEntered * largest * length;
  return std::ranges::all_of(points, [&](const Point3& p) {
    const Point3 v = p - first;
    return std::abs(glm::dot(normal, v)) + kRoundings * glm::dot(sizes, glm::abs(v)) <= most;
  });
}

}  // namespace

bool is_bent(const EnteredPolygon& polygon, double largest) {
  const PointRow& points = polygon.points;
  if (points.size() <= 3) return false;
  const auto support = support_of_entered({points.data(), points.size()});
  if (!support || is_certainly_flat(points, *support, largest)) return false;
  const std::array corners{points[(*support)[0]], points[(*support)[1]], points[(*support)[2]]};
  const Modelling modelling(polygon.modelling, kFlatAsEntered * largest);
  if (modelling.puts_in_line(corners[0], corners[1], corners[2])) return false;
  const EnteredPlane plane(corners, modelling);
  return std::ranges::any_of(points, [&](const Point3& p) { return !plane.reaches(p, modelling); });
}

}  // namespace displayfile
