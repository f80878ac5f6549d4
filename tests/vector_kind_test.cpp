#include "clip/base/vector_kind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "clip/base/error.h"
#include "tests/error_of.h"

namespace displayfile {
namespace {

TEST(VectorKind, IsTheProcessorsWidestOrNoWiderThanAskedFor) {
  const char* const asked = std::getenv("DISPLAYFILE_VECTORS");
  const VectorKind most = asked == nullptr ? VectorKind::avx512 : vector_kind(asked);
  EXPECT_EQ(widest_vectors(), std::min(most, vectors_of_processor()));
}

TEST(VectorKind, HasItsName) {
  EXPECT_EQ(vector_kind("baseline"), VectorKind::baseline);
  EXPECT_EQ(vector_kind("avx512"), VectorKind::avx512);
  EXPECT_EQ(test::error_of([] { vector_kind("avx1"); }),
            "DISPLAYFILE_VECTORS=avx1: expected baseline, sse4, avx2 or avx512");
}

TEST(VectorKind, TheFormIsTheWidestThatIsThere) {
  const auto baseline = +[] { return 0; };
  const auto sse4 = +[] { return 1; };
  const auto avx2 = +[] { return 2; };
  using Form = int();
  const int expected = std::min(2, static_cast<int>(widest_vectors()));
  EXPECT_EQ(widest_form<Form>(baseline, sse4, avx2, nullptr)(), expected);
  EXPECT_EQ(widest_form<Form>(baseline, nullptr, nullptr, nullptr)(), 0);
}

}  // namespace
}  // namespace displayfile
