// libFuzzer target: whatever the text, replaying it throws nothing but Error, and its lines,
// without refused ones, are recorded and replayed to the same display file, unless that takes very
// long.

#include <cstddef>
#include <cstdint>

#include "clip/base/work_budget.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/record_and_replay.h"

/// A program of a few lines may need minutes of sorting, in which nothing new is tested.
constexpr std::uint64_t kMostComparisons = 300'000;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view program(reinterpret_cast<const char*>(data), size);
  displayfile::WorkBudget budget({.comparisons = kMostComparisons});
  const displayfile::BudgetInForce in_force(budget);
  try {
    displayfile::GraphicsSystem system;
    displayfile::replay(program, "program", system);
  } catch (const displayfile::Error&) {
  }
  try {
    if (const auto difference = displayfile::difference_after_record_and_replay(program)) {
      displayfile::fuzz::failed("the recording's dump differs: " + *difference);
    }
  } catch (const displayfile::LimitReached&) {
  }
  return 0;
}
