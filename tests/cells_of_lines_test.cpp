// The cells through which lines go (hidden/lines/cells_of_lines.h), against the lines themselves.

#include "hidden/lines/cells_of_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;

Rectangle around(const Point3& middle, double size) {
  return {middle.x - size, middle.x + size, middle.y - size, middle.y + size};
}

/// As many items as lines are few among, and a few lines.
struct FewLines {
  FewLines(Source& s, int lines, double scale, double from) {
    for (int k = 0; k < lines; ++k) {
      const Point3 a = in_cube(s);
      const Point3 b = a + std::pow(2.0, -s.between(0, 12)) * (in_cube(s) - Point3(0.5));
      list.line(a * scale + from, b * scale + from);
      names.push_back({static_cast<std::uint32_t>(k), 1});
    }
    for (int k = 0; k < 2000; ++k) list.line(Point3(from), Point3(from + scale));
  }
  ItemList list;
  std::vector<LineName> names;
};

TEST(CellsOfLines, WhateverHasAPointOfALineIsNear) {
  for (int seed = 0; seed < 60; ++seed) {
    Source s(static_cast<std::uint64_t>(seed));
    const double scale = std::pow(2.0, s.between(-30, 30)), from = s.between(-3, 3) * scale;
    const FewLines few(s, s.between(1, 30), scale, seed % 2 == 0 ? 0.0 : from * 1000.0);
    const CellsOfLines cells(few.list.view(), few.names, {});
    ASSERT_FALSE(cells.are_everywhere());
    for (int k = 0; k < 2000; ++k) {
      const auto line =
          few.list.points_of(static_cast<std::size_t>(s.below(int(few.names.size()))));
      const Point3 p = line[0] + s.unit() * (line[1] - line[0]);
      const double size = scale * std::pow(2.0, -s.between(0, 30));
      const Point3 middle =
          p + 0.99 * size * Point3(2.0 * s.unit() - 1.0, 2.0 * s.unit() - 1.0, 0.0);
      ASSERT_TRUE(cells.come_near(around(middle, size + 1e-15 * std::abs(from) * 1000.0)))
          << "seed " << seed;
    }
  }
}

TEST(CellsOfLines, MostOfAPictureIsFarFromAFewLines) {
  Source s(1);
  const FewLines few(s, 10, 1.0, 0.0);
  const CellsOfLines cells(few.list.view(), few.names, {});
  ASSERT_FALSE(cells.are_everywhere());
  int near = 0;
  for (int k = 0; k < 1000; ++k) near += cells.come_near(around(in_cube(s), 0.004)) ? 1 : 0;
  EXPECT_GT(near, 0);
  EXPECT_LT(near, 400);
  EXPECT_FALSE(cells.come_near(around({50.0, 50.0, 0.0}, 1.0)));
  EXPECT_TRUE(cells.come_near(around({0.5, 0.5, 0.0}, 100.0)));
}

TEST(CellsOfLines, ALineAlongAnAxisAndAPointHaveCellsToo) {
  ItemList list;
  list.line({0.25, 0.5, 0.0}, {0.75, 0.5, 0.0});
  for (int k = 0; k < 100; ++k) list.line({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
  const LineName line{0, 1};
  const CellsOfLines level(list.view(), {&line, 1}, {});
  EXPECT_TRUE(level.come_near({0.7, 0.8, 0.4, 0.5}));
  EXPECT_FALSE(level.come_near({0.7, 0.8, 0.4, 0.49}));
  list.points[1] = list.points[0];
  const CellsOfLines point(list.view(), {&line, 1}, {});
  EXPECT_TRUE(point.come_near({0.25, 0.25, 0.5, 0.5}));
  EXPECT_FALSE(point.come_near({0.3, 0.4, 0.5, 0.5}));
}

TEST(CellsOfLines, ManyLinesAreEverywhereAndSoAreNone) {
  Source s(1);
  const FewLines many(s, 600, 1.0, 0.0);
  EXPECT_TRUE(CellsOfLines(many.list.view(), many.names, {}).are_everywhere());
  EXPECT_TRUE(CellsOfLines(many.list.view(), {}, {}).are_everywhere());
}

}  // namespace
}  // namespace displayfile
