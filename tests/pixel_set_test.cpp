#include "interp/scan/pixel_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

using test::Dice;

TEST(PixelSet, IsASetOfPixels) {
  Dice dice(3);
  PixelSet set(200, 5, 9);
  EXPECT_TRUE(set.empty());
  std::set<std::pair<int, int>> expected;
  for (int k = 0; k < 300; ++k) {
    const int row = dice.from(5, 8), a = dice.from(0, 200), b = dice.from(0, 200);
    const bool added = dice.one_in(2);
    bool any = false;
    for (int i = std::min(a, b); i < std::max(a, b); ++i) any |= expected.contains({row, i});
    EXPECT_EQ(set.any(row, std::min(a, b), std::max(a, b)), any);
    for (int i = std::min(a, b); i < std::max(a, b); ++i) {
      added ? (void)expected.insert({row, i}) : (void)expected.erase({row, i});
    }
    added ? set.add(row, std::min(a, b), std::max(a, b))
          : set.remove(row, std::min(a, b), std::max(a, b));
    ASSERT_EQ(set.size(), expected.size());
  }
  std::vector<std::pair<int, int>> visited;
  set.for_each([&](int row, int column) { visited.emplace_back(row, column); });
  EXPECT_TRUE(std::ranges::equal(visited, expected));
}

}  // namespace
}  // namespace displayfile
