// The guarantees of in_parallel, with each of the files that share work out (tests/CMakeLists.txt).

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

#include "clip/base/parallel.h"

namespace displayfile {
namespace {

TEST(ShareOut, CallsEachOnceOnThreads) {
  for (const int threads : {1, 2, 3, 64}) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<int> calls(count, 0);
      in_parallel(threads, count, [&](std::size_t k) { ++calls[k]; });
      EXPECT_EQ(std::ranges::count(calls, 1), static_cast<std::ptrdiff_t>(count));
    }
  }
}

TEST(ShareOut, ThrowsWhatACallThrewOnThreads) {
  for (int round = 0; round < 50; ++round) {
    const auto fail = [](std::size_t k) {
      if (k == 7) throw std::out_of_range("7");
    };
    EXPECT_THROW(in_parallel(4, 100, fail), std::out_of_range);
  }
  std::atomic<int> calls = 0;
  in_parallel(4, 100, [&](std::size_t) { ++calls; });
  EXPECT_EQ(calls, 100);
}

TEST(ShareOut, MayBeAskedAgainWithinACallOnThreads) {
  std::atomic<int> calls = 0;
  in_parallel(4, 20, [&](std::size_t) { in_parallel(4, 20, [&](std::size_t) { ++calls; }); });
  EXPECT_EQ(calls, 400);
}

}  // namespace
}  // namespace displayfile
