#pragma once

/// Limits of work, how it is stopped, and how it reports its progress.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

#include "clip/base/error.h"

namespace displayfile {

/// Limits of work; by default there are none (clip/base/work_budget.md).
struct WorkLimits {
  static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();
  /// Into which polygons are cut, that lines are seen in, or edges of a map. What is not cut is
  /// always allowed.
  std::uint64_t pieces = kNone;
  /// Comparisons of a polygon or a line with a polygon or a plane, in sorts, lines and maps. They
  /// are counted in lumps: each thread may do up to 1,024 more.
  std::uint64_t comparisons = kNone;
  /// That one operation's tables take, as it knows before it begins or counts while they grow. What
  /// the allocator adds is not counted, nor what other threads of the process have.
  std::uint64_t bytes = kNone;
  /// Time by a clock, from start() on.
  double seconds = std::numeric_limits<double>::infinity();
};

/// Thrown where a limit is reached, or the work was stopped: the state is then what it was before
/// the call.
class LimitReached : public Error {
 public:
  using Error::Error;
};

/// Limits in force, and a way to stop work. One budget may be in force on several threads, and for
/// several operations, which then share it.
class WorkBudget {
 public:
  explicit WorkBudget(const WorkLimits& limits = {}) : limits_(limits) { start(); }
  WorkBudget(const WorkBudget&) = delete;
  WorkBudget& operator=(const WorkBudget&) = delete;

  /// Seconds and comparisons are counted from now on, and no work is to stop. Not to be called
  /// while work goes on.
  void start();
  void start(const WorkLimits& limits);  ///< that are in force from now on
  const WorkLimits& limits() const { return limits_; }

  /// Stops all work under this budget soon, with LimitReached; also work that begins later.
  /// Any thread may call it, and a signal handler: it is one lock-free store.
  void stop() noexcept { stopped_.store(true, std::memory_order_relaxed); }
  bool is_stopped() const noexcept { return stopped_.load(std::memory_order_relaxed); }

  double seconds() const;  ///< since start()
  std::uint64_t comparisons() const noexcept {
    return comparisons_.load(std::memory_order_relaxed);
  }

  // For the code that works: they throw LimitReached, which names the work, the limit, and a method
  // that would do instead.
  void ask(std::uint64_t more_comparisons = 0);
  void require_pieces(std::uint64_t pieces) const;
  void require_bytes(std::uint64_t bytes) const;

 private:
  WorkLimits limits_;
  std::atomic<bool> stopped_{false};
  std::atomic<std::uint64_t> comparisons_{0};
  std::int64_t started_ = 0;  // nanoseconds, by the steady clock
};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may stop work");

/// The name of the work, for messages, and of what may be done instead. Both must stay.
struct WorkDone {
  const char* what = nullptr;     ///< such as "sorting by bsp"
  const char* instead = nullptr;  ///< such as "hidden-surface method map"; none if nothing is
};

/// The budget of a thread, and its work.
struct WorkInForce {
  WorkBudget* budget = nullptr;
  WorkDone done;
};

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
  const int rounding_before_;
};

/// Called with how much of long work is done, out of all: by one thread at a time, with counts that
/// do not fall, and with all of it last. An exception of it stops the work on every thread and
/// comes out of the routine that was called, which then has changed nothing.
using WorkProgress = std::function<void(std::size_t done, std::size_t all)>;

}  // namespace displayfile
