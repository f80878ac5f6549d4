#pragma once

#include <atomic>
#include <cassert>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "clip/error.h"
#include "clip/round_to_nearest.h"

namespace displayfile {

/// What work may use at most; what is not said is not limited (clip/work_budget.md).
struct WorkLimits {
  static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();
  /// Into which polygons are cut, that lines are seen in, or edges of a map. What is not cut is
  /// always allowed.
  std::uint64_t pieces = kNone;
  /// Comparisons of a polygon or a line with a polygon or a plane, in sorts, lines and maps. They
  /// are counted in lumps: so many more may be done by each thread as WorkSteps says.
  std::uint64_t comparisons = kNone;
  /// That one operation's tables take, as it knows before it begins or counts while they grow. What
  /// the allocator adds is not counted, nor what other threads of the process have.
  std::uint64_t bytes = kNone;
  /// Time by a clock, from start() on.
  double seconds = std::numeric_limits<double>::infinity();
};

/// What is thrown where a limit is reached, or the work told to stop: the state is then what it was
/// before the call.
class LimitReached : public Error {
 public:
  using Error::Error;
};

/// What work may use, and a way to stop it. One budget may be in force on several threads, and for
/// several operations, which then share it.
class WorkBudget {
 public:
  explicit WorkBudget(const WorkLimits& limits = {}) : limits_(limits) { start(); }
  WorkBudget(const WorkBudget&) = delete;
  WorkBudget& operator=(const WorkBudget&) = delete;

  /// Seconds and comparisons are counted from now on, and nothing is told to stop. Not while work
  /// goes on.
  void start();
  void start(const WorkLimits& limits);  ///< that are in force from now on
  const WorkLimits& limits() const { return limits_; }

  /// Tells all work under this budget to stop, soon, with LimitReached; also what begins later.
  /// Any thread may call it, and a signal handler: it is one lock-free store.
  void stop() noexcept { stopped_.store(true, std::memory_order_relaxed); }
  bool is_stopped() const noexcept { return stopped_.load(std::memory_order_relaxed); }

  double seconds() const;  ///< since start()
  std::uint64_t comparisons() const noexcept {
    return comparisons_.load(std::memory_order_relaxed);
  }

  // For whoever works: they throw LimitReached, with what was reached, the limit, and what would
  // serve instead.
  void ask(std::uint64_t more_comparisons = 0);
  void require_pieces(std::uint64_t pieces) const;
  void require_bytes(std::uint64_t bytes) const;

 private:
  WorkLimits limits_;
  std::atomic<bool> stopped_{false};
  std::atomic<std::uint64_t> comparisons_{0};
  std::chrono::steady_clock::time_point started_;
};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may stop work");

/// What is being done, for messages, and what may be done instead. Both must stay.
struct WorkDone {
  const char* what = nullptr;     ///< such as "sorting by bsp"
  const char* instead = nullptr;  ///< such as "hidden-surface method map"; none if nothing is
};

/// What is in force on a thread.
struct WorkInForce {
  WorkBudget* budget = nullptr;
  WorkDone done;
};
WorkInForce work_in_force() noexcept;

/// While it lives, the calls of this thread have that budget, and so have the threads that help it.
/// A null pointer leaves the one in force. They round to nearest, whatever mode the host has set.
/// Must be destroyed on the thread that made it, the last one first.
class BudgetInForce {
 public:
  explicit BudgetInForce(WorkBudget* budget) noexcept;
  explicit BudgetInForce(WorkBudget& budget) noexcept : BudgetInForce(&budget) {}
  explicit BudgetInForce(const WorkInForce& as_on_another_thread) noexcept;
  ~BudgetInForce();
  BudgetInForce(const BudgetInForce&) = delete;
  BudgetInForce& operator=(const BudgetInForce&) = delete;

 private:
  WorkInForce before_;
  RoundToNearest nearest_;
};

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
/// Throws LimitReached if there is a budget in force that does not allow so many bytes, which
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
