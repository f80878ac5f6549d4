// Polygons of several loops that bridges join, as faces with holes and faces in two parts are
// entered: whatever the bridges cross, triangles tile what the even-odd rule fills.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "clip/geometry/corners.h"
#include "displayfile/mesh/joined_by_bridges.h"
#include "hidden/exact/orientation.h"
#include "hidden/triangles/triangulation.h"

namespace displayfile {
namespace {

using Loop = std::vector<Point2>;

/// Twice the area of small whole numbers.
double doubled_area(const Loop& loop) {
  double sum = 0.0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Point2 &p = loop[k], &q = loop[(k + 1) % loop.size()];
    sum += p.x * q.y - q.x * p.y;
  }
  return sum;
}

/// Counterclockwise around a point, at distances from half of `reach` to all of it.
Loop random_star(const Point2& middle, double reach, std::mt19937_64& random) {
  const std::size_t corners = 5 + random() % 8;
  Loop loop;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    const double radius = reach * (0.5 + 0.5 * static_cast<double>(random() % 1000) / 1000.0);
    loop.emplace_back(std::round(middle.x + radius * std::cos(angle)),
                      std::round(middle.y + radius * std::sin(angle)));
  }
  return loop;
}

struct Region {
  std::vector<Loop> loops;
  double area = 0.0;  ///< twice that of what is filled

  void add(Loop loop, bool is_hole, std::mt19937_64& random, bool any_direction) {
    area += (is_hole ? -1.0 : 1.0) * doubled_area(loop);
    if (any_direction ? random() % 2 == 0 : is_hole) std::ranges::reverse(loop);
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(random() % loop.size()),
                loop.end());
    loops.push_back(std::move(loop));
  }
};

/// Up to nine outlines beside each other, some with a hole, some of these with an island in it.
Region random_region(std::mt19937_64& random, bool any_direction) {
  Region region;
  const std::size_t outlines = 1 + random() % 9;
  for (std::size_t k = 0; k < outlines; ++k) {
    const Point2 middle(static_cast<double>(k % 3) * 10000.0, static_cast<double>(k / 3) * 10000.0);
    region.add(random_star(middle, 4000.0, random), false, random, any_direction && k > 0);
    if (random() % 3 == 0) continue;
    region.add(random_star(middle, 1500.0, random), true, random, any_direction);
    if (random() % 2 == 0) continue;
    region.add(random_star(middle, 500.0, random), false, random, any_direction);
  }
  std::shuffle(region.loops.begin() + (any_direction ? 1 : 0), region.loops.end(), random);
  return region;
}

std::size_t corners_of(const Region& region) {
  std::size_t corners = 0;
  for (const Loop& loop : region.loops) corners += loop.size();
  return corners;
}

bool are_apart(const std::array<Point2, 3>& s, const std::array<Point2, 3>& t) {
  const auto separates = [](const std::array<Point2, 3>& one, const std::array<Point2, 3>& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto is_beyond = [&](const Point2& p) {
        return orientation(one[k], one[(k + 1) % 3], p) <= 0;
      };
      if (std::ranges::all_of(other, is_beyond)) return true;
    }
    return false;
  };
  return separates(s, t) || separates(t, s);
}

/// As seen along the x, y or z axis, from one side or from the other.
Point3 in_space(const Point2& p, std::size_t axis, bool mirrored, double lift) {
  Point3 at(lift);
  at[static_cast<int>((axis + 1) % 3)] = p.x;
  at[static_cast<int>((axis + 2) % 3)] = p.y;
  if (mirrored)
    std::swap(at[static_cast<int>((axis + 1) % 3)], at[static_cast<int>((axis + 2) % 3)]);
  return at;
}

void expect_filled(const Region& region, std::size_t axis, bool mirrored, std::mt19937_64& random) {
  const Loop joined = joined_by_bridges<Point2>(region.loops, [](const Point2& p) { return p; });
  std::vector<Point3> polygon;
  for (const Point2& p : joined) {
    polygon.push_back(in_space(p, axis, mirrored, 0.25 * static_cast<double>(random() % 2)));
  }
  // The polygon's own direction is that in which most of its area is circled.
  const double way = doubled_area(joined) < 0.0 ? -1.0 : 1.0;
  Triangulation triangulation;
  double area = 0.0;
  std::size_t sides = 0;
  std::vector<std::array<Point2, 3>> triangles;
  for (const auto& [vertex, edge_visible] : triangulation.triangulate(polygon)) {
    std::array triangle{joined[vertex[0]], joined[vertex[1]], joined[vertex[2]]};
    const double of_triangle = way * doubled_area({triangle[0], triangle[1], triangle[2]});
    if (way < 0.0) std::swap(triangle[0], triangle[1]);
    ASSERT_GE(of_triangle, 0.0);
    area += of_triangle;
    if (of_triangle > 0.0) triangles.push_back(triangle);
    for (const std::uint8_t visible : edge_visible) sides += visible;
  }
  ASSERT_EQ(area, region.area);
  EXPECT_GE(sides, corners_of(region));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) ASSERT_TRUE(are_apart(triangles[i], triangles[k]));
  }
}

TEST(BridgedPolygons, AreFilledByTheEvenOddRule) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Region region = random_region(random, false);
    expect_filled(region, seed % 3, seed % 2 == 1, random);
    if (HasFatalFailure()) return;
  }
}

/// The direction of a hole means nothing to the even-odd rule.
TEST(BridgedPolygons, LoopsMayRunEitherWay) {
  for (std::uint64_t seed = 1000; seed < 1400; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Region region = random_region(random, true);
    expect_filled(region, seed % 3, seed % 2 == 1, random);
    if (HasFatalFailure()) return;
  }
}

/// A side that ends at a corner where a bridge begins has its visibility there.
TEST(BridgedPolygons, SidesKeepTheCornersThatTheyEndAt) {
  const std::vector<Loop> loops{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{4, 0}, {6, 0}, {6, 2}, {4, 2}}};
  std::vector<Point3> polygon;
  for (const Point2& p : joined_by_bridges<Point2>(loops, [](const Point2& q) { return q; })) {
    polygon.emplace_back(p.x, p.y, 0.0);
  }
  ASSERT_EQ(polygon.size(), 10u);
  Triangulation triangulation;
  std::vector<std::uint32_t> ends;
  for (const auto& [vertex, edge_visible] : triangulation.triangulate(polygon)) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (edge_visible[k] != 0) ends.push_back(vertex[k]);
    }
  }
  std::ranges::sort(ends);
  // Sides 4 to 5 and 9 to 0 are the bridge.
  EXPECT_EQ(ends, (std::vector<std::uint32_t>{1, 2, 3, 4, 6, 7, 8, 9}));
}

}  // namespace
}  // namespace displayfile
