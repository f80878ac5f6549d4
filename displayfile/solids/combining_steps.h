#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"

namespace displayfile {

/// Counts the steps of combining two solids, as comparisons of the budget in force. A limit holds
/// without a budget too, so that each combination terminates.
class CombiningSteps {
 public:
  /// The default limit.
  static constexpr std::uint64_t kMost = 100'000'000;

  /// `what` names the combination in messages, such as "the union with part 2 of 3".
  explicit CombiningSteps(std::string what, std::uint64_t most = kMost)
      : what_(std::move(what)), most_(most) {}
  CombiningSteps(const CombiningSteps&) = delete;
  CombiningSteps& operator=(const CombiningSteps&) = delete;

  /// Throws Error beyond the limit, and LimitReached if the budget in force does not allow more.
  void step() {
    if (taken_ == most_) fail();
    ++taken_;
    steps_.step();
  }
  const std::string& what() const { return what_; }

 private:
  [[noreturn]] void fail() const;

  std::string what_;
  std::uint64_t most_;
  std::uint64_t taken_ = 0;
  WorkSteps steps_;
};

}  // namespace displayfile
