#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>

#include "clip/base/work_budget.h"
#include "interp/python/limits.h"

namespace displayfile::python {

/// The context of a call, read while holding the interpreter's lock.
struct Caller {
  std::shared_ptr<LimitsBlock> block = block_in_force();
  bool is_main_thread = is_on_main_thread();  ///< where Python handles signals

  static bool is_on_main_thread();
};

/// During its lifetime, the work of this thread has the limits of the enclosing block, and on the
/// main thread, where Python raises KeyboardInterrupt, a keyboard interrupt (SIGINT) also stops it
/// by LimitReached.
class StoppedByInterrupt {
 public:
  explicit StoppedByInterrupt(const Caller& caller);
  ~StoppedByInterrupt();
  StoppedByInterrupt(const StoppedByInterrupt&) = delete;
  StoppedByInterrupt& operator=(const StoppedByInterrupt&) = delete;

  bool interrupted() const { return listens_ && budget_->is_stopped(); }

 private:
  const Caller& caller_;
  WorkBudget own_;
  WorkBudget* budget_;  ///< its own, or the block's
  bool listens_;
  BudgetInForce in_force_;
};

/// Waits, without the interpreter's lock, until no other thread is in a call on the same object.
/// Limits and interrupts end the wait.
std::unique_lock<std::timed_mutex> turn_of(std::timed_mutex& mutex);

/// Calls work() without the interpreter's lock. If a keyboard interrupt has stopped it, Python's
/// handler is called; if that raises nothing, the work is restarted: stopped work leaves the state
/// unchanged.
template <class Work>
auto without_interpreter(Work&& work) {
  const Caller caller;
  for (;;) {
    bool interrupted = false;
    try {
      const pybind11::gil_scoped_release released;
      const StoppedByInterrupt stopped(caller);
      try {
        return work();
      } catch (const Error&) {
        interrupted = stopped.interrupted();
        throw;
      }
    } catch (const Error&) {
      if (!interrupted) throw;
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    }
  }
}

}  // namespace displayfile::python
