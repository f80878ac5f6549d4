#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <thread>

#include "clip/base/work_budget.h"

namespace displayfile::python {

/// The name in messages of waiting for another thread's call on the same object.
inline constexpr WorkDone kWaiting{"waiting for another thread's call", nullptr};

/// A `with limits(...)` block. Contexts (Python's contextvars) hold the blocks that began in them
/// and in the context that they were copied from.
struct LimitsBlock {
  pybind11::object limits;
  std::thread::id thread;
  std::unique_ptr<WorkBudget> budget;
  bool has_ended = false;

  /// Replaces a stopped budget by one with the remaining limits.
  void renew_budget();
};

/// The innermost block of the context that began on this thread and has not ended; null outside of
/// them.
std::shared_ptr<LimitsBlock> block_in_force();

/// Adds the functions used by limits.
void add_limits(pybind11::module_& module);

}  // namespace displayfile::python
