#include "hidden/triangles/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>
#include <utility>
#include <vector>

#include "clip/geometry/back_face.h"
#include "clip/geometry/corners.h"
#include "clip/geometry/planarity.h"
#include "hidden/exact/orientation.h"
#include "hidden/triangles/ear_cutting.h"
#include "tests/polygon_outlines.h"

namespace displayfile {
namespace {

using test::Outline;
using Polygon = std::vector<Point3>;
using Triangles = std::span<const CornerTriple>;

double area_from_above(std::span<const Point3> p) { return newell_c(p) / 2; }

/// Exactly, of integer coordinates below 2^30: sums on the way may be too large, and wrap.
std::int64_t twice_area(std::span<const Point2> p) {
  std::uint64_t sum = 0;
  const auto product = [](double a, double b) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(a) * static_cast<std::int64_t>(b));
  };
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    const auto u = p[k] - p[0], v = p[k + 1] - p[0];
    sum += product(u.x, v.y) - product(u.y, v.x);
  }
  return static_cast<std::int64_t>(sum);
}

/// Two fewer than it has corners, each side of the polygon in one of them, all else in two that run
/// along it opposite ways.
void expect_all_sides_once(std::size_t n, Triangles triangles) {
  ASSERT_EQ(triangles.size(), n - 2);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const CornerTriple& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(t[k], t[next_corner(k, 3)]);
  }
  std::ranges::sort(sides);
  EXPECT_EQ(std::ranges::adjacent_find(sides), sides.end());
  std::size_t of_polygon = 0;
  for (const auto& [from, to] : sides) {
    if (next_corner(from, static_cast<std::uint32_t>(n)) == to) {
      ++of_polygon;
    } else {
      EXPECT_TRUE(std::ranges::binary_search(sides, std::pair(to, from))) << from << " to " << to;
    }
  }
  EXPECT_EQ(of_polygon, n);
}

/// The triangles tile the polygon: with the above, each point is covered by as many triangles as
/// the polygon winds around it, if none is turned over.
void expect_tiling(const Outline& p, Triangles triangles, bool some_without_area = false) {
  expect_all_sides_once(p.size(), triangles);
  std::int64_t sum = 0;
  for (const auto& [a, b, c] : triangles) {
    EXPECT_GE(orientation(p[a], p[b], p[c]), some_without_area ? 0 : 1);
    sum += twice_area(Outline{p[a], p[b], p[c]});
  }
  EXPECT_EQ(sum, twice_area(p));
}

/// A side of one of the two has all of the other on its far side, or on it; a triangle without area
/// covers nothing.
bool are_disjoint(const Outline& p, const CornerTriple& s, const CornerTriple& t) {
  const auto has_area = [&](const CornerTriple& one) {
    return orientation(p[one[0]], p[one[1]], p[one[2]]) != 0;
  };
  if (!has_area(s) || !has_area(t)) return true;
  const auto separates = [&](const CornerTriple& one, const CornerTriple& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 &from = p[one[k]], &to = p[one[next_corner(k, 3)]];
      if (std::ranges::all_of(other,
                              [&](std::uint32_t v) { return orientation(from, to, p[v]) <= 0; })) {
        return true;
      }
    }
    return false;
  };
  return separates(s, t) || separates(t, s);
}

void expect_disjoint(const Outline& p, Triangles triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_TRUE(are_disjoint(p, triangles[i], triangles[k])) << i << " and " << k;
    }
  }
}

/// From each corner on, since nothing may depend on which is the first.
void expect_swept_from_anywhere(const Outline& p, bool some_without_area = false) {
  for (std::size_t first = 0; first < p.size(); ++first) {
    Outline from = p;
    std::rotate(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(first), from.end());
    std::vector<CornerTriple> triangles;
    ASSERT_TRUE(sweep_triangles(from, triangles)) << "from corner " << first;
    expect_tiling(from, triangles, some_without_area);
    expect_disjoint(from, triangles);
  }
}

/// The four positions of a polygon with integer coordinates.
std::vector<Outline> turned(const Outline& outline) {
  std::vector<Outline> all{outline};
  for (int k = 1; k < 4; ++k) {
    Outline next;
    for (const Point2& p : all.back()) next.emplace_back(-p.y, p.x);
    all.push_back(next);
  }
  return all;
}

std::vector<Outline> outlines(std::size_t corners, std::uint64_t seed) {
  const auto cells = static_cast<std::size_t>(std::sqrt(static_cast<double>(corners) / 2));
  return {test::star_outline(corners, seed), test::spiral_outline(corners),
          test::comb_outline(corners, seed, false), test::comb_outline(corners, seed, true),
          test::tree_outline(cells, seed)};
}

TEST(Triangulation, ASweepTilesSmallPolygonsFromAnyCorner) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const Outline& outline : outlines(8 + 4 * seed, seed)) {
      for (const Outline& p : turned(outline)) expect_swept_from_anywhere(p);
    }
  }
}

// Random polygons of few corners on a small grid: many in line, as high as others, or repeated.
TEST(Triangulation, TheSweepCutsWhatDoesNotCrossItself) {
  std::mt19937_64 random(5);
  int simple = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    Outline p(4 + random() % 5);
    for (Point2& v : p)
      v = Point2(static_cast<double>(random() % 5), static_cast<double>(random() % 5));
    const auto n = p.size();
    const auto meets = [&](std::size_t i, std::size_t k) {  // sides that are not neighbours
      const Point2 &a = p[i], &b = p[next_corner(i, n)], &c = p[k], &d = p[next_corner(k, n)];
      const auto within = [](const Point2& u, const Point2& v, const Point2& w) {
        return orientation(u, v, w) == 0 && std::min(u.x, v.x) <= w.x &&
               w.x <= std::max(u.x, v.x) && std::min(u.y, v.y) <= w.y && w.y <= std::max(u.y, v.y);
      };
      if (within(a, b, c) || within(a, b, d) || within(c, d, a) || within(c, d, b)) return true;
      return orientation(a, b, c) * orientation(a, b, d) < 0 &&
             orientation(c, d, a) * orientation(c, d, b) < 0;
    };
    bool is_simple = true;
    for (std::size_t i = 0; i < n && is_simple; ++i) {
      const std::size_t next = next_corner(i, n), after = next_corner(next, n);
      is_simple = p[i] != p[next] && !(orientation(p[i], p[next], p[after]) == 0 &&
                                       glm::dot(p[next] - p[i], p[after] - p[next]) < 0);
      for (std::size_t k = i + 2; k < n && is_simple; ++k) {
        if (!(i == 0 && k == n - 1)) is_simple = !meets(i, k);
      }
    }
    std::vector<CornerTriple> triangles;
    const bool swept = sweep_triangles(p, triangles);
    if (!swept) {
      EXPECT_TRUE(triangles.empty());
      EXPECT_FALSE(is_simple);
      continue;
    }
    expect_all_sides_once(n, triangles);
    simple += is_simple ? 1 : 0;
    const int way = twice_area(p) < 0 ? -1 : 1;
    for (const auto& [a, b, c] : triangles) {
      const int turn = way * orientation(p[a], p[b], p[c]);
      EXPECT_GE(turn, is_simple ? 1 : 0);
    }
    if (is_simple) expect_disjoint(p, triangles);
    if (::testing::Test::HasFailure()) {
      for (const Point2& v : p) std::printf("(%g, %g) ", v.x, v.y);
      return;
    }
  }
  EXPECT_GT(simple, 10000);
}

TEST(Triangulation, LargePolygonsAreTiled) {
  for (const std::size_t corners : {100u, 1000u, 9000u, 100000u}) {
    for (const Outline& p : outlines(corners, corners)) {
      std::vector<CornerTriple> triangles;
      ASSERT_TRUE(sweep_triangles(p, triangles)) << corners;
      expect_tiling(p, triangles);
    }
  }
}

// The sums from which the normal is found are rounded; the sweep is not given the orientation.
TEST(Triangulation, APolygonThatRunsClockwiseKeepsItsTurning) {
  for (Outline p : outlines(100, 3)) {
    std::ranges::reverse(p);
    std::vector<CornerTriple> triangles;
    ASSERT_TRUE(sweep_triangles(p, triangles));
    expect_all_sides_once(p.size(), triangles);
    for (const auto& [a, b, c] : triangles) EXPECT_EQ(orientation(p[a], p[b], p[c]), -1);
  }
}

TEST(Triangulation, RepeatedPointsAddTrianglesWithoutArea) {
  const Outline p{{0, 0}, {0, 0}, {8, 0}, {8, 0}, {8, 0}, {4, 2}, {8, 8}, {0, 8}, {0, 8}, {0, 0}};
  for (const Outline& t : turned(p)) expect_swept_from_anywhere(t, true);
  for (const Outline& nothing : {Outline(70, {1, 1}), [] {
                                   Outline two(70, {1, 1});
                                   two[7] = {2, 2};
                                   return two;
                                 }()}) {
    std::vector<CornerTriple> triangles;
    sweep_triangles(nothing, triangles);
    Polygon in_space;
    for (const Point2& v : nothing) in_space.emplace_back(v, 0.0);
    Triangulation triangulation;
    EXPECT_EQ(triangulation.triangulate(in_space).size(), 68u);
  }
}

TEST(Triangulation, PolygonsThatTouchThemselvesAreTiled) {
  const struct {
    const char* what;
    Outline polygon;
  } cases[] = {
      {"a hole, and the way to it",
       {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}}},
      {"a hole, from within a side",
       {{4, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {4, 0}, {4, 3}, {3, 6}, {6, 6}, {6, 3}, {4, 3}}},
      {"two holes, one behind the other",
       {{0, 0},
        {9, 0},
        {9, 9},
        {0, 9},
        {0, 0},
        {1, 1},
        {1, 3},
        {3, 3},
        {5, 5},
        {5, 7},
        {7, 7},
        {7, 5},
        {5, 5},
        {3, 3},
        {3, 1},
        {1, 1}}},
      {"two holes at one corner",
       {{0, 0},
        {9, 0},
        {9, 9},
        {0, 9},
        {0, 0},
        {1, 5},
        {1, 7},
        {3, 7},
        {3, 5},
        {1, 5},
        {0, 0},
        {2, 1},
        {2, 3},
        {4, 3},
        {4, 1},
        {2, 1}}},
      {"a neck without width", {{0, 0}, {8, 0}, {4, 4}, {8, 8}, {0, 8}, {4, 4}}},
      {"a corner on another side", {{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}},
      {"a slit", {{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 3}, {4, 8}, {0, 8}}},
      {"a thorn", {{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 12}, {4, 8}, {0, 8}}},
      {"a slit from below, as wide as nothing",
       {{0, 0}, {4, 0}, {4, 5}, {4, 0}, {8, 0}, {8, 8}, {0, 8}}},
      {"slits in slits",
       {{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 4}, {6, 4}, {4, 4}, {2, 4}, {4, 4}, {4, 8}, {0, 8}}},
      {"corners that meet in a point",
       {{0, 0}, {8, 0}, {4, 4}, {8, 2}, {8, 8}, {4, 4}, {6, 8}, {2, 8}, {4, 4}, {0, 8}}},
  };
  for (const auto& [what, polygon] : cases) {
    SCOPED_TRACE(what);
    for (const Outline& p : turned(polygon)) expect_swept_from_anywhere(p, true);
  }
}

// A plate with many holes, each with a way to it, as sections of meshes are.
TEST(Triangulation, APlateWithHolesIsSwept) {
  constexpr int kHoles = 2000;
  Outline plate{{0, 0}, {1e6, 0}, {1e6, 1e6}, {0, 1e6}, {0, 0}};
  for (int k = kHoles; k-- > 0;) {  // ways from the corner, the steeper first
    const Point2 at(10.0 * (kHoles - k), 10.0 * k + 1000.0);
    plate.insert(plate.end(), {at, at + Point2(-1, 3), at + Point2(2, 5), at + Point2(3, 1), at});
    plate.push_back(plate.front());
  }
  plate.pop_back();
  std::vector<CornerTriple> triangles;
  ASSERT_TRUE(sweep_triangles(plate, triangles));
  expect_tiling(plate, triangles, true);
}

TEST(Triangulation, TrianglesTileThePolygonWithHiddenDiagonals) {
  // A concave, bent polygon: an L folded along its diagonal.
  const Polygon bent{{0, 0, 0}, {3, 0, 0}, {3, 1, 0.5}, {1, 1, 0}, {1, 3, 0.5}, {0, 3, 0}};
  ASSERT_FALSE(is_flat(bent));
  Triangulation triangulation;
  const auto triangles = triangulation.triangulate(bent);
  ASSERT_EQ(triangles.size(), 4u);
  double sum = 0;
  std::ptrdiff_t sides = 0;
  for (const auto& t : triangles) {
    const Polygon piece{bent[t.vertex[0]], bent[t.vertex[1]], bent[t.vertex[2]]};
    EXPECT_GT(area_from_above(piece), 0.0);  // no piece is turned over
    sum += area_from_above(piece);
    sides += std::ranges::count(t.edge_visible, 1);
  }
  EXPECT_DOUBLE_EQ(sum, area_from_above(bent));
  EXPECT_EQ(sides, 6);  // each side of the polygon once, no diagonal
}

/// All that is promised of a polygon that crosses itself.
void expect_cut(const Polygon& p) {
  Triangulation triangulation;
  std::vector<CornerTriple> triangles;
  std::size_t visible = 0;
  for (const auto& t : triangulation.triangulate(p)) {
    triangles.push_back(t.vertex);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = static_cast<std::uint32_t>(p.size());
      const bool is_side = next_corner(t.vertex[previous_corner(k, 3)], n) == t.vertex[k];
      EXPECT_EQ(t.edge_visible[k], is_side ? 1 : 0);
      visible += t.edge_visible[k];
    }
  }
  EXPECT_EQ(visible, p.size());
  expect_all_sides_once(p.size(), triangles);
}

// Such a polygon has few ears; it must not take cubic time, nor quadratic.
TEST(Triangulation, SteepPolygonsAreTiledAsSeenAlongZWhereTheyDoNotCrossThemselvesSo) {
  std::mt19937_64 random(7);
  const auto steep = [&] { return 1e6 * (static_cast<double>(random() % 1000) - 500.0); };
  int tiled_otherwise = 0;
  for (std::size_t trial = 0; trial < 2000; ++trial) {
    const Outline outline = test::star_outline(3 + trial % 20, 8 + trial);
    Polygon polygon;
    for (const Point2& p : outline) polygon.emplace_back(p.x, p.y, steep());
    if (trial % 2 == 1) std::ranges::reverse(polygon);
    const auto are_reversed = [&](std::span<const Triangulation::Triangle> triangles) {
      return std::ranges::any_of(triangles, [&](const Triangulation::Triangle& t) {
        const Polygon corners{polygon[t.vertex[0]], polygon[t.vertex[1]], polygon[t.vertex[2]]};
        return area_from_above(corners) * area_from_above(polygon) < 0.0;
      });
    };
    Triangulation triangulation;
    tiled_otherwise += are_reversed(triangulation.triangulate(polygon)) ? 0 : 1;
    const auto triangles = triangulation.triangulate(polygon, Triangulation::SeenAlong::z_axis);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    ASSERT_FALSE(are_reversed(triangles)) << trial;
  }
  EXPECT_LT(tiled_otherwise, 1500) << "polygons that the other direction tiles too";
  // One that stands on edge, or crosses itself from there, is cut as it is by default.
  const Polygon upright = {{0, 0, 0}, {1, 1, 0}, {2, 2, 3}, {1, 1, 2}};
  const Polygon bow_tie = {{0, 0, 0}, {1, 1, 0}, {1, 0, 5}, {0, 1, 9}};
  // As seen along y, the nearest axis, this one does not cross itself.
  const Polygon twisted = {{1, 0, 1}, {0, 0.1, 1}, {0, 0, 0}, {1, 0.2, 0}};
  for (const Polygon& polygon : {upright, bow_tie, twisted}) {
    Triangulation one, other;
    const auto by_default = one.triangulate(polygon);
    const auto along_z = other.triangulate(polygon, Triangulation::SeenAlong::z_axis);
    EXPECT_TRUE(std::ranges::equal(by_default, along_z, {}, &Triangulation::Triangle::vertex,
                                   &Triangulation::Triangle::vertex));
  }
}

/// The number of triangles around a point, on either side; sides count as they fall.
int triangles_around(const Point2& at, std::span<const Triangulation::Triangle> triangles,
                     std::span<const Point3> all) {
  int around = 0;
  for (const auto& t : triangles) {
    int left = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 &p = all[t.vertex[k]], &q = all[t.vertex[(k + 1) % 3]];
      left += (q.x - p.x) * (at.y - p.y) > (q.y - p.y) * (at.x - p.x) ? 1 : -1;
    }
    around += left == 3 || left == -3 ? 1 : 0;
  }
  return around;
}

bool is_inside_even_odd(const Point2& at, std::span<const Point3> polygon) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point3 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    if ((p.y > at.y) == (q.y > at.y)) continue;
    if (at.x < p.x + (q.x - p.x) * (at.y - p.y) / (q.y - p.y)) inside = !inside;
  }
  return inside;
}

TEST(Triangulation, APolygonThatCrossesItselfIsTiledByTheEvenOddRule) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  Triangulation triangulation;
  const auto expect_even_odd = [&](const Polygon& polygon) {
    const auto triangles = triangulation.tile(polygon);
    const Polygon all = triangulation.with_crossings(polygon);
    for (int n = 0; n < 200; ++n) {
      const Point2 at(u(random), u(random));
      ASSERT_EQ(triangles_around(at, triangles, all), is_inside_even_odd(at, polygon) ? 1 : 0);
    }
    for (const auto& t : triangles) {  // parts of the polygon's sides alone are sides
      for (std::size_t k = 0; k < 3; ++k) {
        if (t.edge_visible[k] == 0) continue;
        const Point3 middle = 0.5 * (all[t.vertex[k]] + all[t.vertex[(k + 2) % 3]]);
        bool is_on_side = false;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const Point3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
          is_on_side |=
              glm::distance(p, middle) + glm::distance(q, middle) < glm::distance(p, q) + 1e-9;
        }
        EXPECT_TRUE(is_on_side);
      }
    }
  };
  expect_even_odd({{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}});
  EXPECT_EQ(triangulation.crossings().size(), 1u);
  for (const int corners : {5, 41}) {
    Polygon star;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * 3.141592653589793 * (corners / 2) * k / corners;
      star.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    expect_even_odd(star);
  }
  for (int round = 0; round < 300; ++round) {
    Polygon tangle;
    for (int k = 0; k < 4 + round % 17; ++k) tangle.emplace_back(u(random), u(random), 0);
    if (round % 3 == 0) {
      for (Point3& p : tangle) p = glm::round(3.0 * p) / 3.0;
    }
    triangulation.triangulate(tangle);
    if (triangulation.crosses_itself()) expect_even_odd(tangle);
  }
  // A steep one, seen from the side, with values at its crossing.
  expect_even_odd({{-1, -1, 5}, {1, 1, 7}, {1, -1, 7}, {-1, 1, 5}});
  EXPECT_EQ(
      triangulation.with_crossings(Polygon{{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {0, 0, 8}}).back(),
      Point3(0.5, 1, 2));
  triangulation.tile(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  EXPECT_TRUE(triangulation.crossings().empty());
  EXPECT_FALSE(triangulation.crosses_itself());
}

TEST(Triangulation, ATangleOfManyVerticesIsCutToo) {
  for (const std::size_t corners : {65u, 500u, 100000u}) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> u(-1, 1);
    Polygon tangle, flat_tangle, star;
    for (std::size_t k = 0; k < corners; ++k) {
      tangle.emplace_back(u(random), u(random), u(random));
      flat_tangle.emplace_back(static_cast<double>(random() % 8), static_cast<double>(random() % 8),
                               0);
      const double angle = 2.5 * static_cast<double>(k);
      star.emplace_back(std::cos(angle), std::sin(angle), 0.1 * u(random));
    }
    expect_cut(tangle);
    expect_cut(flat_tangle);
    expect_cut(star);
  }
}

// Up to kMostForEars corners the triangles are those of ears, beyond they cover the same.
TEST(Triangulation, FewCornersAreCutByEars) {
  Triangulation triangulation, by_ears;
  for (const std::size_t corners : {20u, 60u, 600u}) {
    for (const Outline& outline : outlines(corners, 9)) {
      Polygon p;
      for (const Point2& v : outline) p.emplace_back(v.y, 0.25 * v.x, v.x);
      const auto triangles = triangulation.triangulate(p), ears = by_ears.triangulate_by_ears(p);
      ASSERT_EQ(triangles.size(), ears.size());
      const bool few = p.size() <= Triangulation::kMostForEars;
      for (std::size_t k = 0; few && k < ears.size(); ++k)
        EXPECT_EQ(triangles[k].vertex, ears[k].vertex);
      expect_cut(p);
      for (const auto& t : triangles) {
        EXPECT_GE(newell_normal(Polygon{p[t.vertex[0]], p[t.vertex[1]], p[t.vertex[2]]}).y, 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace displayfile
