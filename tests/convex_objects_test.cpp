// Roberts's objects (hidden/lines/convex_objects.h): which polygons hide together, and that this
// does not change what is visible.

#include "hidden/lines/convex_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "hidden/lines/visible_lines.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;

using Sets = std::vector<std::vector<std::uint32_t>>;

/// The objects of more than one polygon.
Sets objects_with_outline(const ItemList& list) {
  const Primitives items = list.view();
  const LineTable scene(items, {}, 1);
  const ConvexObjects objects(items, scene);
  Sets sets;
  std::size_t polygons = 0;
  for (std::uint32_t k = 0; k < objects.size(); ++k) {
    const auto of = objects.polygons(k);
    polygons += of.size();
    if (!objects.outline(k).empty()) sets.emplace_back(of.begin(), of.end());
  }
  std::size_t hiding = 0;
  for (std::uint32_t i = 0; i < scene.items(); ++i) hiding += scene.hides(i) ? 1 : 0;
  EXPECT_EQ(polygons, hiding);
  return sets;
}

/// A box seen from a corner: its faces as a parallel projection shows them.
void add_box(ItemList& list, const Point3& at, const Point3& size) {
  const auto corner = [&](int k) {
    const Point3 p = at + Point3(k & 1, (k >> 1) & 1, (k >> 2) & 1) * size;
    return Point3(p.x + 0.5 * p.z, p.y + 0.25 * p.z, p.z + 0.125 * p.x);
  };
  constexpr std::array<std::array<int, 4>, 6> kFaces{
      {{4, 5, 7, 6}, {1, 0, 2, 3}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 4, 6, 2}, {5, 1, 3, 7}}};
  for (const auto& face : kFaces) {
    list.solid({corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3])});
  }
}

TEST(ConvexObjects, TheFacesThatABoxTurnsToTheViewerAreOneAndTheOthersAreOne) {
  ItemList list;
  add_box(list, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
  const Sets sets = objects_with_outline(list);
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(sets[0].size(), 3u);
  EXPECT_EQ(sets[1].size(), 3u);
}

TEST(ConvexObjects, PolygonsWithoutAConvexOutlineAreEachByThemselves) {
  ItemList bent;  // an L of two squares beside each other and one above
  const auto square = [&](double x, double y) {
    bent.solid({{x, y, 0.5}, {x + 1, y, 0.5}, {x + 1, y + 1, 0.5}, {x, y + 1, 0.5}});
  };
  square(0.0, 0.0);
  square(1.0, 0.0);
  square(0.0, 1.0);
  EXPECT_TRUE(objects_with_outline(bent).empty());
  square(1.0, 1.0);
  EXPECT_EQ(objects_with_outline(bent), (Sets{{0, 1, 2, 3}}));
}

TEST(ConvexObjects, PolygonsThatFoldOverASideAreNoObject) {
  ItemList folded;
  folded.solid({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.5}});
  folded.solid({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.25, 1.0, 0.75}});
  EXPECT_TRUE(objects_with_outline(folded).empty());
}

TEST(ConvexObjects, ASurfaceWithAHoleOrAroundTwiceIsNone) {
  ItemList ring;  // eight quadrilaterals around a square hole
  const auto at = [](int i, int j) { return Point3(i, j, 0.5); };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (i == 1 && j == 1) continue;
      ring.solid({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  EXPECT_TRUE(objects_with_outline(ring).empty());
}

/// Boxes in three rows, and lines through all of them.
TEST(ConvexObjects, WhatIsSeenIsWhatEachPolygonLeaves) {
  ItemList list;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      add_box(list, {1.5 * i, 1.25 * j, 0.5 * ((i * 3 + j) % 4)}, {1.0, 1.0 + 0.25 * (i % 2), 0.5});
    }
  }
  for (int k = 0; k < 60; ++k) {
    list.line({0.25 * (k % 7), 0.125 * k, 0.0625 * (k % 20)},
              {9.0 - 0.25 * (k % 5), 8.0 - 0.125 * k, 0.0625 * (k % 31)});
  }
  const Sets sets = objects_with_outline(list);
  EXPECT_EQ(sets.size(), 50u);
  const auto lines = drawn_lines(list.view());
  const SeenLines seen = visible_lines(list.view(), lines, {.method = HiddenMethod::roberts});
  EXPECT_EQ(seen.pieces,
            visible_lines(list.view(), lines, {.method = HiddenMethod::franklin}).pieces);
  EXPECT_LT(seen.pieces.size(), 4 * lines.size());
}

/// Solids on a small lattice, so that they touch, share sides and lie in one plane; half of them
/// are turned.
TEST(ConvexObjects, NothingChangesAmongSolidsThatTouch) {
  std::mt19937 random(20261123);
  const auto whole = [&](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  std::size_t found = 0;
  for (int scene = 0; scene < 400; ++scene) {
    ItemList list;
    const int solids = whole(2, 6);
    for (int k = 0; k < solids; ++k) {
      const Point3 at(whole(0, 4), whole(0, 4), whole(0, 4));
      if (whole(0, 1) == 0) {
        add_box(list, at, Point3(whole(1, 3), whole(1, 3), whole(1, 3)));
        continue;
      }
      const Point3 p = at, q = at + Point3(whole(-2, 2), whole(-2, 2), whole(-2, 2));
      const Point3 r(whole(0, 4), whole(0, 4), whole(0, 4)), top(2, 2, whole(0, 6));
      for (const Loop& face : {Loop{p, q, r}, Loop{p, q, top}, Loop{q, r, top}, Loop{r, p, top}}) {
        list.solid(face);
      }
    }
    for (int k = 0; k < 6; ++k) {
      list.line(Point3(whole(-1, 6), whole(-1, 6), whole(0, 4)),
                Point3(whole(-1, 6), whole(-1, 6), whole(0, 4)));
    }
    found += objects_with_outline(list).size();
    const auto lines = drawn_lines(list.view());
    ASSERT_EQ(visible_lines(list.view(), lines, {.method = HiddenMethod::roberts}).pieces,
              visible_lines(list.view(), lines, {.method = HiddenMethod::franklin}).pieces)
        << list.text();
  }
  EXPECT_GT(found, 800u);
}

}  // namespace
}  // namespace displayfile
