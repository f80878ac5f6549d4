// Appel's method (hidden/lines/appel.md): where counts are carried and where they must not be.
// hidden_lines_test.cpp tests that it agrees with the other methods.

#include "hidden/lines/line_methods.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "hidden/lines/contour_edges.h"
#include "hidden/lines/simple_polygon.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;

/// The counts of Appel's method for all drawn lines; its pieces are Roberts's.
AppelCounts found_as_by_roberts(const ItemList& list, const SurfacePlan& options = {}) {
  const Primitives items = list.view();
  const std::vector<LineName> lines = drawn_lines(items);
  const LineTable scene(items, lines, options.threads);
  AppelCounts counts;
  const SeenLines seen = visible_lines_by_appel(items, scene, options, &counts);
  EXPECT_EQ(seen.pieces, visible_lines(items, lines, options.by(HiddenMethod::roberts)).pieces);
  EXPECT_EQ(counts.rays + counts.carried, scene.first_lines().size());
  return counts;
}

std::size_t contour_edges(const ItemList& list) {
  const Primitives items = list.view();
  const LineTable scene(items, {}, 1);
  return ContourEdges(scene, items, SideTable(items), 1).size();
}

/// An octahedron divided into 8 * 4^levels triangles on a sphere.
void add_ball(ItemList& list, const Point3& middle, double radius, int levels) {
  const auto turned = [](const Point3& p) {
    return Point3(0.8 * p.x - 0.6 * p.z, 0.36 * p.x + 0.8 * p.y + 0.48 * p.z,
                  0.48 * p.x - 0.6 * p.y + 0.64 * p.z);
  };
  const auto divide = [&](const auto& again, const Point3& p, const Point3& q, const Point3& r,
                          int level) -> void {
    if (level == 0) {
      list.solid(
          {middle + radius * turned(p), middle + radius * turned(q), middle + radius * turned(r)});
      return;
    }
    const Point3 pq = glm::normalize(p + q), qr = glm::normalize(q + r), rp = glm::normalize(r + p);
    again(again, p, pq, rp, level - 1);
    again(again, pq, q, qr, level - 1);
    again(again, rp, qr, r, level - 1);
    again(again, pq, qr, rp, level - 1);
  };
  for (const double x : {1.0, -1.0}) {
    for (const double y : {1.0, -1.0}) {
      for (const double z : {1.0, -1.0}) {
        divide(divide, {x, 0.0, 0.0}, {0.0, y, 0.0}, {0.0, 0.0, z}, levels);
      }
    }
  }
}

TEST(Appel, OneRayForEachClosedMesh) {
  ItemList list;
  add_ball(list, {0.4, 0.5, 0.5}, 0.3, 3);
  const AppelCounts one = found_as_by_roberts(list);
  EXPECT_EQ(one.rays, 1u);
  EXPECT_EQ(one.carried, 8u * 64u * 3u / 2u - 1u);
  EXPECT_LT(one.contour_edges, 100u);  // those of the outline
  add_ball(list, {0.6, 0.45, 0.2}, 0.3, 3);
  EXPECT_EQ(found_as_by_roberts(list).rays, 2u);  // the first hides a part of the second
  add_ball(list, {0.5, 0.55, 0.35}, 0.3, 3);      // it goes through both
  EXPECT_EQ(found_as_by_roberts(list).rays, 3u);
}

/// The sum over all lines, in parts of each line's length.
double seen_of_lines(const SeenLines& seen) {
  double all = 0.0;
  for (const VisiblePiece& piece : seen.pieces) all += piece.to - piece.from;
  return all;
}

TEST(Appel, CountsAreCarriedWithRoundoffToo) {
  ItemList list;
  add_ball(list, {0.4, 0.5, 0.5}, 0.3, 3);
  add_ball(list, {0.5, 0.45, 0.2}, 0.3, 3);
  const Primitives items = list.view();
  const std::vector<LineName> lines = drawn_lines(items);
  const LineTable scene(items, lines, 1);
  SurfacePlan roundoff;
  roundoff.precision.exact = false;
  AppelCounts counts;
  const SeenLines seen = visible_lines_by_appel(items, scene, roundoff, &counts);
  EXPECT_EQ(counts.rays, 2u);
  EXPECT_NEAR(seen_of_lines(seen), seen_of_lines(visible_lines_by_appel(items, scene, {})), 1e-6);
}

TEST(Appel, ContourEdgesAreWhereTheNumberOfPolygonsChanges) {
  ItemList list;
  list.solid(square(0.0, 0.0, 0.5, 1.0, 0.5));
  EXPECT_EQ(contour_edges(list), 4u);
  list.solid(
      square(0.5, 0.0, 1.0, 1.0, 0.5));  // the side between them is not a contour edge any more
  EXPECT_EQ(contour_edges(list), 6u);
  list.solid({{0.5, 0.0, 0.5}, {0.5, 1.0, 0.5}, {0.2, 1.0, 0.7}, {0.2, 0.0, 0.7}});  // a fold
  EXPECT_EQ(contour_edges(list), 10u);
  list.hollow(square(0.0, 0.0, 0.9, 0.9, 0.1));
  list.line({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
  EXPECT_EQ(contour_edges(list), 10u);
  ItemList bow_tie;  // it is compared, not counted
  bow_tie.solid({{0.0, 0.0, 0.5}, {1.0, 1.0, 0.5}, {1.0, 0.0, 0.5}, {0.0, 1.0, 0.5}});
  EXPECT_EQ(contour_edges(bow_tie), 0u);
}

/// Lines from point to point, before, behind and through the list's polygons.
ItemList with_path(ItemList list, const std::vector<Point3>& path) {
  for (std::size_t k = 1; k < path.size(); ++k) list.line(path[k - 1], path[k]);
  return list;
}

TEST(Appel, CountsChangeAtAVertexOfTheStar) {
  ItemList list;
  list.solid({{0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}, {0.75, 0.75, 0.5}});
  // To the triangle's corner, and on behind it, before it and beside it.
  const Point3 corner(0.25, 0.25, 0.5);
  for (const Point3& beyond : {Point3(0.75, 0.5, 0.0), Point3(0.75, 0.5, 1.0),
                               Point3(0.25, 1.0, 0.0), Point3(0.0, 0.0, 0.0)}) {
    const AppelCounts counts =
        found_as_by_roberts(with_path(list, {{0.0, 0.125, 0.5}, corner, beyond}));
    EXPECT_EQ(counts.rays, 1u);
    EXPECT_EQ(counts.carried, 4u);
  }
}

TEST(Appel, CountsAreNotCarriedOverAVertexThatAContourPassesBefore) {
  ItemList list;
  list.solid(square(0.25, 0.25, 0.75, 0.75, 0.5));
  const Point3 behind(0.25, 0.5, 0.25), before(0.25, 0.5, 0.75);
  const Point3 from(0.0, 0.375, 0.25), to(0.5, 0.625, 0.25);
  // One ray for the square's sides, and one for each line.
  EXPECT_EQ(found_as_by_roberts(with_path(list, {from, behind, to})).rays, 3u);
  EXPECT_EQ(found_as_by_roberts(with_path(list, {from, before, to})).rays, 2u);
  // Exactly behind its corner.
  const Point3 corner(0.25, 0.25, 0.25);
  EXPECT_EQ(found_as_by_roberts(with_path(list, {from, corner, to})).rays, 3u);
}

TEST(Appel, CountsAreNotCarriedOverAVertexThatTouchesAFace) {
  ItemList list;
  list.solid(square(0.25, 0.25, 0.75, 0.75, 0.5));
  // Inside it, where the path goes through it, and on its side.
  for (const Point3& touching : {Point3(0.5, 0.5, 0.5), Point3(0.5, 0.25, 0.5)}) {
    const auto path = with_path(list, {{0.375, 0.0, 0.75}, touching, {0.5, 0.625, 0.25}});
    EXPECT_EQ(found_as_by_roberts(path).rays, 3u);
  }
}

TEST(Appel, CountsAreCarriedAlongALineFromEitherEnd) {
  ItemList list;
  list.solid(square(0.25, 0.25, 0.75, 0.75, 0.5));
  // The first vertex is behind the square's side, the path comes out from behind it and goes on.
  const auto path =
      with_path(list, {{0.25, 0.5, 0.25}, {0.5, 0.6, 0.25}, {0.5, 0.9, 0.25}, {0.1, 0.9, 0.25}});
  EXPECT_EQ(found_as_by_roberts(path).rays, 2u);
}

TEST(Appel, CountsAreCarriedOverPolygonsThatAreNotFlat) {
  ItemList list;  // a tube, open at its ends, of quadrilaterals that are all twisted
  const auto at = [](int i, int j) {
    const double angle = 0.3 + std::numbers::pi * (i / 8.0 + j / 40.0);
    return Point3(0.1 + 0.08 * j, 0.5 + 0.3 * std::cos(angle), 0.5 + 0.3 * std::sin(angle));
  };
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 16; ++i)
      list.solid({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  const AppelCounts counts = found_as_by_roberts(list);
  EXPECT_LE(counts.rays, 20u);
  EXPECT_GE(counts.carried, 300u);
}

TEST(Appel, LargeStarsAreLeftOut) {
  ItemList list;
  const auto rim = [](int k) {
    const double angle = 0.1 + 2.0 * std::numbers::pi * k / 100.0;
    return Point3(0.5 + 0.4 * std::cos(angle), 0.5 + 0.4 * std::sin(angle), 0.25);
  };
  for (int k = 0; k < 100; ++k) list.solid({{0.5, 0.6, 0.75}, rim(k), rim((k + 1) % 100)});
  EXPECT_EQ(found_as_by_roberts(list).rays, 1u);
}

TEST(Appel, AnyNumberOfThreadsFindsTheSameInTheSameWay) {
  ItemList list;
  for (int k = 0; k < 12; ++k) add_ball(list, {0.3 + 0.03 * k, 0.5, 0.5 - 0.1 * k}, 0.2, 2);
  const AppelCounts one = found_as_by_roberts(list),
                    three = found_as_by_roberts(list, {.threads = 3});
  EXPECT_EQ(one.rays, 12u);
  EXPECT_EQ(three.rays, one.rays);
}

TEST(Appel, LinesThroughSidesInSpace) {
  ItemList list;  // a roof, and lines that go through its ridge and its corner
  const Point3 a(0.0, 0.5, 0.75), b(1.0, 0.5, 0.75);
  list.solid({{0.0, 0.0, 0.25}, {1.0, 0.0, 0.25}, b, a});
  list.solid({a, b, {1.0, 1.0, 0.25}, {0.0, 1.0, 0.25}});
  for (const Point3& to : {Point3(0.5, 1.0, 1.0), Point3(0.5, 1.0, 0.75), Point3(0.5, 1.0, 0.0)}) {
    const Point3 from = 2.0 * Point3(0.5, 0.5, 0.75) - to;
    found_as_by_roberts(with_path(list, {from, to}));
    const Point3 beside = 2.0 * a - to;
    found_as_by_roberts(with_path(list, {beside, to}));
  }
}

TEST(Appel, ConcavePolygonsAreCounted) {
  ItemList list;
  list.solid({{0.0, 0.0, 0.5},
              {1.0, 0.0, 0.5},
              {1.0, 1.0, 0.5},
              {0.75, 1.0, 0.5},
              {0.75, 0.5, 0.5},
              {0.25, 0.5, 0.5},
              {0.25, 1.0, 0.5},
              {0.0, 1.0, 0.5}});
  EXPECT_EQ(contour_edges(list), 8u);
  const Point3 reflex(0.75, 0.5, 0.5);
  const auto path = with_path(list, {{0.5, 0.75, 0.25}, reflex, {0.9, 0.1, 0.25}});
  EXPECT_EQ(found_as_by_roberts(path).rays, 1u);
}

TEST(SimplePolygon, TurnsOneWayIfItsSidesDoNotMeet) {
  using Outline = std::vector<Point2>;
  const auto turning = [](const Outline& outline) {
    return simple_turning(outline.size(), [&](std::size_t k) { return outline[k]; });
  };
  const Outline notched{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 2}, {1, 2}, {1, 4}, {0, 4}};
  EXPECT_EQ(turning(notched), 1);
  EXPECT_EQ(turning({notched.rbegin(), notched.rend()}), -1);
  EXPECT_EQ(turning({{0, 0}, {1, 0}, {0, 1}}), 1);
  EXPECT_EQ(turning({{0, 0}, {1, 0}, {2, 0}, {2, 2}}), 1);                  // three in line
  EXPECT_EQ(turning({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), 0);                  // it crosses itself
  EXPECT_EQ(turning({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), 0);          // a corner on a side
  EXPECT_EQ(turning({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}), 1);          // not quite
  EXPECT_EQ(turning({{0, 0}, {2, 0}, {2, 2}, {2, 3}, {2, 1}, {0, 2}}), 0);  // it folds back
  EXPECT_EQ(turning({{0, 0}, {2, 0}, {2, 0}, {1, 1}, {0, 2}}), 0);          // one corner twice
}

}  // namespace
}  // namespace displayfile
