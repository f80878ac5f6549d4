#pragma once

#include <pybind11/pybind11.h>

#include <csignal>

#include "clip/work_budget.h"

namespace displayfile::python {

/// To be called when the module is imported, by the thread on which Python handles signals.
void remember_main_thread();

/// While it lives, the work of this thread has the limits of the block in which it is called
/// (interp/python/limits.h), and an interrupt from the keyboard (SIGINT) stops it by LimitReached,
/// beside what Python does with it. The latter on the main thread alone, where Python raises
/// KeyboardInterrupt.
class StoppedByInterrupt {
 public:
  StoppedByInterrupt();
  ~StoppedByInterrupt();
  StoppedByInterrupt(const StoppedByInterrupt&) = delete;
  StoppedByInterrupt& operator=(const StoppedByInterrupt&) = delete;

  bool interrupted() const { return listens_ && budget_->is_stopped(); }

 private:
  WorkBudget own_;
  WorkBudget* budget_;  ///< its own, or the block's
  bool listens_;
  BudgetInForce in_force_;
};

/// Calls work() without the interpreter's lock. When an interrupt from the keyboard has stopped it,
/// Python's handler is called; if that raises nothing, the work begins again: what was stopped has
/// left the state as it was.
template <class Work>
auto without_interpreter(Work&& work) {
  for (;;) {
    bool interrupted = false;
    try {
      const pybind11::gil_scoped_release released;
      const StoppedByInterrupt stopped;
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
