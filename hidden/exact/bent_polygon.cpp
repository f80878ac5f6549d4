#include "hidden/exact/bent_polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "hidden/exact/entered_plane.h"

namespace displayfile {

namespace {

double largest_of(const Point3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// In doubles, and false if they do not tell. The matrix makes a distance longer by less than twice
/// its longest column. With u = 2^-53 each coordinate of the normal is off by less than 6 u times
/// the sides' largest ones, and the product with the way to a vertex by less than 24 u of all
/// three.
bool is_certainly_flat(const PointRow& points, const std::array<std::size_t, 3>& support,
                       double largest) {
  constexpr double kOfSides = 0x1p-48;
  const Point3 first = points[support[0]];
  const Point3 a = points[support[1]] - first, b = points[support[2]] - first;
  const Point3 normal = glm::cross(a, b);
  const double error = kOfSides * largest_of(a) * largest_of(b);
  const double most = 0.5 * kFlatAsEntered * largest * (largest_of(normal) - error);
  for (const Point3& p : points) {
    const Point3 v = p - first;
    if (!(std::abs(glm::dot(normal, v)) + error * largest_of(v) <= most)) return false;
  }
  return true;
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
