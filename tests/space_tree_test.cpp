#include "hidden/boxes/space_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/sort_truth.h"

namespace displayfile {
namespace {

using test::Source;

std::vector<Bounds> random_boxes(Source& s, int count) {
  std::vector<Bounds> boxes(static_cast<std::size_t>(count));
  for (Bounds& box : boxes) {
    const Point3 at(s.between(-20, 20), s.between(-20, 20), s.between(-20, 20));
    box.include(at);
    box.include(at + Point3(s.between(0, 6), s.between(0, 6), s.between(0, 6)));
  }
  return boxes;
}

/// By its definition, in long doubles: from, to and slopes are small whole numbers.
bool ray_meets(const Point3& from, const Point3& direction, const Bounds& box) {
  long double enters = 0.0L, leaves = INFINITY;
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0.0) {
      if (from[k] < box.low[k] || from[k] > box.high[k]) return false;
      continue;
    }
    const long double a = (static_cast<long double>(box.low[k]) - from[k]) / direction[k];
    const long double b = (static_cast<long double>(box.high[k]) - from[k]) / direction[k];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  return enters <= leaves;
}

TEST(SpaceTree, ARayFindsAllBoxesThatItMeets) {
  Source s(3);
  for (const int count : {0, 1, 8, 9, 300, 3000}) {
    const std::vector<Bounds> boxes = random_boxes(s, count);
    std::vector<Bounds> larger = boxes;
    for (Bounds& box : larger) box.low -= 0x1p-30, box.high += 0x1p-30;
    SpaceTree tree;
    tree.build(larger, 2);
    for (int trial = 0; trial < 40; ++trial) {
      const Point3 from(s.between(-30, 30), s.between(-30, 30), s.between(-30, 30));
      const Point3 direction(s.between(-3, 3), s.between(-3, 3), s.between(1, 3));
      std::vector<int> visits(boxes.size());
      EXPECT_FALSE(tree.any(SpaceRay(from, direction), [&](SpaceTree::Position p) {
        ++visits[tree.order()[p]];
        return false;
      }));
      std::size_t needless = 0;  // nearly touched
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_LE(visits[i], 1);
        const bool meets = ray_meets(from, direction, boxes[i]);
        EXPECT_TRUE(visits[i] == 1 || !meets) << i;
        needless += !meets && visits[i] == 1 ? 1 : 0;
      }
      EXPECT_LE(needless, boxes.size() / 100) << "only what is nearly touched";
    }
  }
}

TEST(SpaceTree, EndsWithTheFirstThatWillDo) {
  Source s(4);
  const std::vector<Bounds> boxes = random_boxes(s, 500);
  SpaceTree tree;
  tree.build(boxes, 1);
  int visits = 0;
  const auto all = [](const SpaceBoxes&) {
    SpaceTree::Lanes met;
    met.fill(1);
    return met;
  };
  EXPECT_TRUE(tree.any(all, [&](SpaceTree::Position) { return ++visits == 3; }));
  EXPECT_EQ(visits, 3);
}

TEST(SpaceTree, TheSameOnAnyNumberOfThreads) {
  Source s(5);
  const std::vector<Bounds> boxes = random_boxes(s, 20'000);
  SpaceTree one, two;
  one.build(boxes, 1);
  two.build(boxes, 2);
  EXPECT_TRUE(std::ranges::equal(one.order(), two.order()));
  EXPECT_LE(one.depth(), 7u);
}

}  // namespace
}  // namespace displayfile
