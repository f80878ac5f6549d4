// The grid of keys finds the same as a search by all pairs.

#include "hidden/touching/key_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "tests/predicate_inputs.h"

namespace displayfile {
namespace {

using test::Source;

/// All that a search must find, by comparing with each.
TEST(KeyGrid, FindsAllWithinTheTolerance) {
  for (const double smallest : {0x1p-49, 1e-9, 1e-3}) {
    Source s(7);
    constexpr std::uint32_t kNumbers = 500;
    std::vector<KeyGrid::Keys> keys;
    std::vector<double> tolerances;
    for (std::uint32_t k = 0; k < kNumbers; ++k) {
      KeyGrid::Keys own{3.0 * s.unit(), 3.0 * s.unit(), 3.0 * s.unit()};
      tolerances.push_back(smallest * std::ldexp(1.0 + s.unit(), static_cast<int>(s.below(6))));
      if (k > 0 && s.below(2) == 0) {  // about as far from another's as the tolerance
        const KeyGrid::Keys& other = keys[s.bits() % k];
        for (std::size_t i = 0; i < 3; ++i) {
          own[i] = std::max(0.0, other[i] + (2.0 * s.unit() - 1.0) * tolerances.back());
        }
      }
      keys.push_back(own);
    }
    std::size_t found = 0;
    for (const bool all : {true, false}) {
      KeyGrid grid(tolerances);
      const auto near_of = [&](std::uint32_t k) {
        std::set<std::uint32_t> near;
        grid.visit_near(keys[k], tolerances[k], [&](std::uint32_t i) {
          near.insert(i);
          return true;
        });
        return near;
      };
      for (std::uint32_t k = 0; k < kNumbers; ++k) {
        if (all || k % 3 == 0) grid.insert(k, keys[k]);
      }
      for (std::uint32_t k = 0; k < kNumbers; ++k) {
        ASSERT_TRUE(grid.has_size_for(tolerances[k]));
        const std::set<std::uint32_t> near = near_of(k);
        for (std::uint32_t i = 0; i < kNumbers; ++i) {
          bool is_near = all || i % 3 == 0;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            is_near &= std::abs(keys[i][axis] - keys[k][axis]) <= tolerances[k];
          }
          EXPECT_TRUE(!is_near || near.contains(i));
          found += is_near && i != k ? 1 : 0;
        }
      }
    }
    EXPECT_GT(found, 100u);
  }
}

TEST(KeyGrid, HasNoCubesForLargeTolerances) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(KeyGrid(std::vector{infinity, 3.0}).has_size_for(3.0));
  const KeyGrid grid(std::vector{infinity, 1e-3});
  EXPECT_TRUE(grid.has_size_for(1e-3));
  EXPECT_FALSE(grid.has_size_for(infinity));
}

}  // namespace
}  // namespace displayfile
