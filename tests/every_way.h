#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/slower.h"
#include "tests/sort_truth.h"

// The invariants of the object-space sorts.

namespace displayfile::test {

/// All that must hold of an exact sort.
inline std::string judged(const ItemList& list, const Way& way, std::uint64_t seed, int samples) {
  const SortedPieces pieces = sorted(list, way);
  const SortJudge judge(list, pieces);
  if (std::string wrong = judge.items(); !wrong.empty()) return wrong;
  if (std::string wrong = judge.areas(1e-12); !wrong.empty()) return wrong;
  if (std::string wrong = judge.outlines(); !wrong.empty()) return wrong;
  Source s(seed);
  for (int k = 0; k < samples; ++k) {
    if (std::string wrong = judge.order_at(any_sample(s)); !wrong.empty()) return wrong;
  }
  return judge.lines_at(0.1 + 0.8 * s.unit());
}

/// By each method at each precision.
class EveryWay : public testing::TestWithParam<Way> {};

}  // namespace displayfile::test
