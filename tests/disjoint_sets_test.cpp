#include "hidden/disjoint_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "tests/sort_truth.h"

namespace displayfile {
namespace {

using test::Source;

TEST(DisjointSets, SetsAreNamedByTheirSmallestMember) {
  Source s(5);
  for (int trial = 0; trial < 100; ++trial) {
    const auto size = static_cast<std::uint32_t>(s.between(1, 60));
    DisjointSets sets(size);
    std::vector<std::uint32_t> name(size);  // by its definition
    std::iota(name.begin(), name.end(), 0u);
    for (int joins = s.between(0, 60); joins > 0; --joins) {
      const auto i = static_cast<std::uint32_t>(s.below(static_cast<int>(size)));
      const auto j = static_cast<std::uint32_t>(s.below(static_cast<int>(size)));
      sets.join(i, j);
      const auto [less, more] = std::minmax(name[i], name[j]);
      const std::uint32_t from = more, to = less;
      std::ranges::replace(name, from, to);
    }
    for (std::uint32_t i = 0; i < size; ++i) {
      EXPECT_EQ(sets.name(i), name[i]);
      EXPECT_EQ(sets.joined(i, 0), name[i] == 0);
    }
  }
}

TEST(DisjointSets, NewMembersAndThoseTakenOutAreAlone) {
  DisjointSets sets(3);
  sets.join(2, 1);
  sets.resize(5);
  sets.join(4, 2);
  EXPECT_EQ(sets.size(), 5u);
  EXPECT_EQ(sets.name(4), 1u);
  EXPECT_EQ(sets.name(3), 3u);
  for (const std::uint32_t i : {1u, 2u, 4u}) sets.make_alone(i);
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(sets.name(i), i);
}

TEST(DisjointSets, AMillionInAChain) {
  constexpr std::uint32_t kMany = 1000000;
  DisjointSets sets(kMany);
  for (std::uint32_t i = kMany - 1; i > 0; --i) sets.join(i, i - 1);
  EXPECT_EQ(sets.name(kMany - 1), 0u);
}

}  // namespace
}  // namespace displayfile
