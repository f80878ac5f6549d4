#pragma once

#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "clip/base/work_budget.h"

namespace displayfile {

/// This thread's budget in force, and its current work.
WorkInForce work_in_force() noexcept;

/// Names this thread's work in messages during its lifetime.
class NamedWork {
 public:
  explicit NamedWork(const WorkDone& done) noexcept;
  ~NamedWork();
  NamedWork(const NamedWork&) = delete;
  NamedWork& operator=(const NamedWork&) = delete;

  /// The work of this thread when the last exception left it; none if other work has begun since.
  static WorkDone left_by_exception() noexcept;
  /// Begins other work, which may be unnamed.
  static void begin_other() noexcept;

 private:
  WorkDone before_;
};

/// Calls ask() of the budget in force, if any.
void ask_budget();
/// Throws LimitReached if the budget in force, if any, does not allow the bytes that of_tables()
/// counts.
template <class Count>
void require_bytes(const Count& of_tables) {
  if (const WorkBudget* const budget = work_in_force().budget) {
    budget->require_bytes(of_tables());
  }
}

/// Counts the pieces that several threads make in one operation, and their memory.
class PieceCount {
 public:
  /// `allowed` pieces are always permitted: the number without any cuts.
  PieceCount(std::uint64_t allowed, std::size_t bytes_of_piece)
      : allowed_(allowed), bytes_of_piece_(bytes_of_piece) {}
  void add(std::uint64_t more);

 private:
  const std::uint64_t allowed_;
  const std::size_t bytes_of_piece_;
  std::atomic<std::uint64_t> pieces_{0};
};

/// Counts the steps of a loop with slow steps, and checks the budget in force periodically. For one
/// thread.
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

/// Counts painted rows of pixels, overlapping ones too, and checks the budget's time periodically.
/// For one thread.
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

/// Suppresses the alternative method in messages of limits during its lifetime (WorkDone, for work
/// named by this thread), for commands with only one method.
class WithoutChoice {
 public:
  WithoutChoice() noexcept;
  ~WithoutChoice();
  WithoutChoice(const WithoutChoice&) = delete;
  WithoutChoice& operator=(const WithoutChoice&) = delete;

 private:
  bool before_;
};

}  // namespace displayfile
