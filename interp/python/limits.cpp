#include "interp/python/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "clip/error.h"
#include "interp/python/arguments.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

thread_local std::vector<std::unique_ptr<WorkBudget>> blocks;

WorkLimits limits_in(py::handle pieces, py::handle comparisons, py::handle bytes,
                     py::handle seconds) {
  WorkLimits limits;
  if (!pieces.is_none()) limits.pieces = count_in(pieces, "pieces");
  if (!comparisons.is_none()) limits.comparisons = count_in(comparisons, "comparisons");
  if (!bytes.is_none()) limits.bytes = count_in(bytes, "bytes");
  if (!seconds.is_none()) {
    limits.seconds = number_in(seconds, "seconds");
    if (limits.seconds < 0.0) {
      throw Error(fmt::format("seconds: {}: expected 0 or more", limits.seconds));
    }
  }
  return limits;
}

}  // namespace

WorkBudget* budget_of_block() { return blocks.empty() ? nullptr : blocks.back().get(); }

void renew_budget_of_block() {
  const WorkBudget& used = *blocks.back();
  WorkLimits left = used.limits();
  left.seconds = std::max(0.0, left.seconds - used.seconds());
  left.comparisons -= std::min(left.comparisons, used.comparisons());
  blocks.back() = std::make_unique<WorkBudget>(left);
}

void add_limits(py::module_& module) {
  module.def("_require_limits",
             [](py::handle pieces, py::handle comparisons, py::handle bytes, py::handle seconds) {
               limits_in(pieces, comparisons, bytes, seconds);
             });
  module.def("_begin_limits", [](py::handle pieces, py::handle comparisons, py::handle bytes,
                                 py::handle seconds) {
    blocks.push_back(std::make_unique<WorkBudget>(limits_in(pieces, comparisons, bytes, seconds)));
  });
  module.def("_end_limits", [] {
    if (blocks.empty()) throw Error("limits: expected to end on the thread on which they began");
    blocks.pop_back();
  });
}

}  // namespace displayfile::python
