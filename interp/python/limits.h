#pragma once

#include <pybind11/pybind11.h>

#include "clip/work_budget.h"

namespace displayfile::python {

/// The budget of the innermost `with limits(...)` block of this thread; null outside of them.
WorkBudget* budget_of_block();
/// It was told to stop: another one, of what is left of it, takes its place.
void renew_budget_of_block();

/// Adds what limits is made of.
void add_limits(pybind11::module_& module);

}  // namespace displayfile::python
