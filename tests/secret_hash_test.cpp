// Hashes of files' contents.

#include "clip/geometry/secret_hash.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace displayfile {
namespace {

TEST(SecretHash, EqualKeysHaveEqualHashesInOneProcess) {
  const SecretHash one, other;
  EXPECT_EQ(one(Point3(0.0, -0.0, 1.5)), other(Point3(-0.0, 0.0, 1.5)));
  EXPECT_EQ(one(std::uint64_t{7}), other(std::uint64_t{7}));
  EXPECT_NE(one(Point3(1, 2, 3)), one(Point3(3, 2, 1)));
  EXPECT_NE(one(Point3(1, 2, 3), 1), one(Point3(1, 2, 3), 2));
}

/// Keys that differ in few high bits, as powers of two do.
TEST(SecretHash, KeysInARowFallIntoManyPlaces) {
  constexpr std::size_t kPlaces = 1 << 11;
  const SecretHash hash;
  std::set<std::size_t> of_powers, of_whole, of_pairs;
  for (int k = 0; k < 1000; ++k) {
    of_powers.insert(hash(Point3(0, 0, std::ldexp(1.0, k - 500))) % kPlaces);
    of_whole.insert(hash(Point3(k, 0, 0)) % kPlaces);
    of_pairs.insert(hash(static_cast<std::uint64_t>(k) << 32) % kPlaces);
  }
  for (const auto* places : {&of_powers, &of_whole, &of_pairs}) EXPECT_GT(places->size(), 600u);
}

}  // namespace
}  // namespace displayfile
