#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/work_budget.h"

namespace displayfile {

/// Called by the module that combines two solids, at each step of it.
class CombiningSteps {
 public:
  /// Throws if the work is to end.
  virtual void step() = 0;

 protected:
  ~CombiningSteps() = default;
};

/// Counts the steps in which two solids are combined. They count as comparisons of the budget in
/// force. There is a limit without a budget, too, so that each combination ends.
class CountedSteps final : public CombiningSteps {
 public:
  /// The default limit.
  static constexpr std::uint64_t kMost = 100'000'000;

  /// `what` names the combination in messages, such as "the union with part 2 of 3".
  explicit CountedSteps(std::string what, std::uint64_t most = kMost)
      : what_(std::move(what)), most_(most) {}
  CountedSteps(const CountedSteps&) = delete;
  CountedSteps& operator=(const CountedSteps&) = delete;

  /// Throws Error beyond the limit, and LimitReached if the budget in force does not allow more.
  void step() override {
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

inline void CountedSteps::fail() const {
  throw Error(
      fmt::format("{} is not found in {} steps: expected parts that meet in fewer places, or of "
                  "fewer polygons",
                  what_, most_));
}

}  // namespace displayfile
