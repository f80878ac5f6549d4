#pragma once

#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "clip/base/work_budget.h"

namespace displayfile {

/// The budget that is in force on this thread, and the work that it does.
WorkInForce work_in_force() noexcept;

/// While it lives, messages of this thread say that this is being done.
class NamedWork {
 public:
  explicit NamedWork(const WorkDone& done) noexcept;
  ~NamedWork();
  NamedWork(const NamedWork&) = delete;
  NamedWork& operator=(const NamedWork&) = delete;

  /// What was being done on this thread when the last exception left it; nothing if other work has
  /// begun since.
  static WorkDone left_by_exception() noexcept;
  /// Other work begins, that need not have a name.
  static void begin_other() noexcept;

 private:
  WorkDone before_;
};

/// Asks the budget in force, if there is one.
void ask_budget();
/// Throws LimitReached if there is a budget in force that does not allow `bytes` bytes, which
/// of_tables() counts.
template <class Count>
void require_bytes(const Count& of_tables) {
  if (const WorkBudget* const budget = work_in_force().budget) {
    budget->require_bytes(of_tables());
  }
}

/// Counts the pieces that several threads make of one work, and what they take.
class PieceCount {
 public:
  /// So many are always allowed, as many as there would be if nothing were cut.
  PieceCount(std::uint64_t allowed, std::size_t bytes_of_piece)
      : allowed_(allowed), bytes_of_piece_(bytes_of_piece) {}
  void add(std::uint64_t more);

 private:
  const std::uint64_t allowed_;
  const std::size_t bytes_of_piece_;
  std::atomic<std::uint64_t> pieces_{0};
};

/// Counts the steps of a loop, each of which takes a while, and asks the budget in force now and
/// then. One thread uses it.
class WorkSteps {
 public:
  static constexpr std::uint32_t kAtATime = 1024;

  void step() {
    assert(left_ > 0);
    if (--left_ == 0) ask();
  }
  void step(std::size_t steps) {
    if (steps >= left_) return ask_of(steps);
    left_ -= static_cast<std::uint32_t>(steps);
  }

 private:
  void ask();
  void ask_of(std::size_t steps);

  std::uint32_t left_ = kAtATime;
};

/// Counts rows of pixels that are painted, however many polygons lie over each other there, and
/// asks the budget in force now and then for its time. One thread uses it.
class RowsPainted {
 public:
  static constexpr std::size_t kAtATime = 256;

  void add(std::size_t rows) {
    if (rows >= left_) return ask();
    left_ -= rows;
  }

 private:
  void ask();

  std::size_t left_ = kAtATime;
};

}  // namespace displayfile
