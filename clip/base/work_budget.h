#pragma once

/// Limits on work, stopping it, and progress reports.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

#include "clip/base/error.h"

namespace displayfile {

/// Limits on work; the default is none (clip/base/work_budget.md).
struct WorkLimits {
  static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();
  /// Pieces of cut polygons, visible pieces of lines, or edges of a map. Uncut input is always
  /// allowed.
  std::uint64_t pieces = kNone;
  /// Comparisons of a polygon or line with a polygon or plane, in sorts, lines and maps. They are
  /// counted in batches: each thread may exceed the limit by up to 1,024.
  std::uint64_t comparisons = kNone;
  /// Bytes of one operation's tables, known beforehand or counted as they grow. Excludes the
  /// allocator's overhead and the memory of other threads.
  std::uint64_t bytes = kNone;
  /// Elapsed time since start().
  double seconds = std::numeric_limits<double>::infinity();
};

/// Thrown when a limit is reached or the work was stopped; the state is then what it was before the
/// call.
class LimitReached : public Error {
 public:
  using Error::Error;
};

/// Limits in force, and a way to stop work. Several threads and operations may share one budget.
class WorkBudget {
 public:
  explicit WorkBudget(const WorkLimits& limits = {}) : limits_(limits) { start(); }
  WorkBudget(const WorkBudget&) = delete;
  WorkBudget& operator=(const WorkBudget&) = delete;

  /// Resets the counts of seconds and comparisons and clears stop(). Must not be called during
  /// work.
  void start();
  void start(const WorkLimits& limits);  ///< and sets new limits
  const WorkLimits& limits() const { return limits_; }

  /// Stops all work under this budget soon, with LimitReached, including work that begins later.
  /// Any thread or signal handler may call it: it is one lock-free store.
  void stop() noexcept { stopped_.store(true, std::memory_order_relaxed); }
  bool is_stopped() const noexcept { return stopped_.load(std::memory_order_relaxed); }

  double seconds() const;  ///< since start()
  std::uint64_t comparisons() const noexcept {
    return comparisons_.load(std::memory_order_relaxed);
  }

  // Called by the working code. They throw LimitReached, whose message names the work, the limit,
  // and an alternative method.
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

/// The name of the work and of an alternative, for messages. Both strings must outlive it.
struct WorkDone {
  const char* what = nullptr;     ///< such as "sorting by bsp"
  const char* instead = nullptr;  ///< such as "hidden-surface method map"; null: none
};

/// A thread's budget and current work.
struct WorkInForce {
  WorkBudget* budget = nullptr;
  WorkDone done;
};

/// Puts a budget in force during its lifetime, for calls of this thread and the threads that help
/// it. A null pointer leaves the current one in force. These threads round to nearest, whatever
/// mode the host has set. Must be destroyed on the thread that made it, in reverse order.
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

/// Reports progress: called with the work done and the total, by one thread at a time, with
/// non-decreasing counts, and with the total last. An exception it throws stops the work on every
/// thread and leaves the routine that was called, whose state is then unchanged.
using WorkProgress = std::function<void(std::size_t done, std::size_t all)>;

}  // namespace displayfile
