// Which points lie in the plane of a polygon: against rationals.

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "hidden/exact/entered_plane.h"
#include "tests/from_environment.h"
#include "tests/slower.h"
#include "tests/touching_scenes.h"

namespace displayfile {
namespace {

using test::any_matrix;
using test::decimal;
using test::Source;

using Q = mpq_class;
using Place = std::array<Q, 3>;

Place placed(const glm::dmat4x3* m, const Point3& p) {
  if (m == nullptr) return {Q(p.x), Q(p.y), Q(p.z)};
  Place world;
  for (int r = 0; r < 3; ++r) {
    world[static_cast<std::size_t>(r)] =
        Q((*m)[0][r]) * Q(p.x) + Q((*m)[1][r]) * Q(p.y) + Q((*m)[2][r]) * Q(p.z) + Q((*m)[3][r]);
  }
  return world;
}
Q product(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Q longest_squared(const glm::dmat4x3* m) {
  if (m == nullptr) return 1;
  Q longest = 0;
  for (int k = 0; k < 3; ++k) {
    const Place column{Q((*m)[k].x), Q((*m)[k].y), Q((*m)[k].z)};
    longest = std::max(longest, product(column, column));
  }
  return longest;
}

/// By the definition, in rationals, for a triangle's plane.
bool lies_in_rationally(const Point3& v, const glm::dmat4x3* of_point,
                        const std::array<Point3, 3>& triangle, const glm::dmat4x3* of_plane,
                        double reach) {
  const Place p = placed(of_plane, triangle[0]);
  const Place a = minus(placed(of_plane, triangle[1]), p);
  const Place b = minus(placed(of_plane, triangle[2]), p);
  const Place n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const Q s = product(n, minus(placed(of_point, v), p));
  const Q longest = std::max(longest_squared(of_point), longest_squared(of_plane));
  return s * s <= Q(reach) * Q(reach) * longest * product(n, n);
}

Point3 any_point(Source& s) {
  const double x = decimal(s, -1, 1), y = decimal(s, -1, 1), z = decimal(s, -1, 1);
  return {x, y, z};
}

/// Points at about the reach from a plane, and at about its fractions and multiples.
TEST(EnteredPlane, ReachesPointsAsInRationals) {
  std::size_t in = 0, out = 0;
  const auto trials = static_cast<std::uint64_t>(
      200 * test::from_environment("DISPLAYFILE_TOUCHING_SCENES", 60 / test::kSlower));
  for (std::uint64_t seed = 0; seed < trials; ++seed) {
    Source s(seed);
    const glm::dmat4x3 first = any_matrix(s), second = any_matrix(s);
    const glm::dmat4x3* const of_plane = s.below(2) == 0 ? nullptr : &first;
    const glm::dmat4x3* const of_point = s.below(2) == 0   ? of_plane
                                         : s.below(2) == 0 ? nullptr
                                                           : &second;
    const std::array<Point3, 3> triangle{any_point(s), any_point(s), any_point(s)};
    const Point3 a = triangle[1] - triangle[0], b = triangle[2] - triangle[0];
    const Point3 n = glm::cross(a, b);
    if (glm::length(n) < 1e-3) continue;
    constexpr std::array<double, 6> kReach{0.0, 1e-200, 0x1p-52, 0x1p-49, 0x1p-49, 1e-3};
    const double reach = kReach[static_cast<std::size_t>(s.below(6))];
    constexpr std::array<double, 8> kHeight{0.0, 0.5, 0.9, 0.99, 1.0, 1.0, 1.01, 2.0};
    const double height = kHeight[static_cast<std::size_t>(s.below(8))] * reach;
    Point3 v = triangle[0] + a * decimal(s, -2, 2) + b * decimal(s, -2, 2);
    v += glm::normalize(n) * (s.below(2) == 0 ? height : -height);
    if (s.below(3) == 0) v.x = std::nextafter(v.x, s.below(2) == 0 ? 9.0 : -9.0);
    if (s.below(4) == 0) v = triangle[static_cast<std::size_t>(s.below(3))];
    if (of_point != of_plane) {
      // The same place under the other matrix, up to rounding.
      const glm::dmat4 there = of_plane == nullptr ? glm::dmat4(1.0) : glm::dmat4(*of_plane);
      const glm::dmat4 here = of_point == nullptr ? glm::dmat4(1.0) : glm::dmat4(*of_point);
      v = Point3(glm::inverse(here) * (there * HomogeneousPoint(v, 1.0)));
    }
    const Modelling modelling(of_plane, reach);
    const EnteredPlane plane(triangle, modelling);
    const bool expected = lies_in_rationally(v, of_point, triangle, of_plane, reach);
    ASSERT_EQ(plane.reaches(v, Modelling(of_point, reach)), expected) << "seed " << seed;
    ++(expected ? in : out);
  }
  EXPECT_GT(in, trials / 8);
  EXPECT_GT(out, trials / 8);
}

/// Exactly at the reach it lies in the plane, a unit farther it does not.
TEST(EnteredPlane, ReachesPointsAtTheReach) {
  const EnteredPlane::Corners floor{Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0)};
  for (const double reach : {0x1p-49, 0.1, 1e-30, 1e-200}) {
    const Modelling none(nullptr, reach);
    const EnteredPlane plane(floor, none);
    for (const double sign : {1.0, -1.0}) {
      EXPECT_TRUE(plane.reaches({0.7, 0.3, sign * reach}, none));
      EXPECT_FALSE(plane.reaches({0.7, 0.3, sign * std::nextafter(reach, 1.0)}, none));
    }
    // Under a matrix that doubles, both are twice as far, and so is the reach.
    const glm::dmat4x3 matrix(2.0);
    const Modelling twice(&matrix, reach);
    EXPECT_TRUE(plane.reaches({0.7, 0.3, reach}, twice));
    EXPECT_FALSE(plane.reaches({0.7, 0.3, std::nextafter(reach, 1.0)}, twice));
  }
}

}  // namespace
}  // namespace displayfile
