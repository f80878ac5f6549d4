#include "interp/python/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "interp/python/arguments.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

PyObject* blocks = nullptr;  // a context variable, of a tuple; it lives as long as the process

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

py::tuple blocks_of_context() {
  PyObject* known = nullptr;
  if (PyContextVar_Get(blocks, nullptr, &known) != 0) throw py::error_already_set();
  return py::reinterpret_steal<py::tuple>(known);
}

void set_blocks_of_context(const py::list& known) {
  const py::object token =
      py::reinterpret_steal<py::object>(PyContextVar_Set(blocks, py::tuple(known).ptr()));
  if (!token) throw py::error_already_set();
}

/// The blocks that have not ended; a copied context may also hold ended ones.
py::list blocks_that_last() {
  py::list last;
  for (const py::handle known : blocks_of_context()) {
    if (!known.cast<const LimitsBlock&>().has_ended) last.append(known);
  }
  return last;
}

void begin_limits(const py::object& limits, py::handle pieces, py::handle comparisons,
                  py::handle bytes, py::handle seconds) {
  auto budget = std::make_unique<WorkBudget>(limits_in(pieces, comparisons, bytes, seconds));
  py::list known = blocks_that_last();
  known.append(std::make_shared<LimitsBlock>(
      LimitsBlock{limits, std::this_thread::get_id(), std::move(budget)}));
  set_blocks_of_context(known);
}

/// Ends the last block that these limits began, which need not be the innermost: blocks of
/// generators begin and end in any order.
void end_limits(const py::object& limits) {
  const py::list known = blocks_that_last();
  for (std::size_t k = known.size(); k-- > 0;) {
    auto& block = known[k].cast<LimitsBlock&>();
    if (!block.limits.is(limits)) continue;
    block.has_ended = true;
    return set_blocks_of_context(blocks_that_last());
  }
  throw Error("limits: expected to end in the thread and the context in which they began");
}

}  // namespace

std::shared_ptr<LimitsBlock> block_in_force() {
  const py::tuple known = blocks_of_context();
  for (std::size_t k = known.size(); k-- > 0;) {
    auto block = known[k].cast<std::shared_ptr<LimitsBlock>>();
    if (!block->has_ended && block->thread == std::this_thread::get_id()) return block;
  }
  return nullptr;
}

void LimitsBlock::renew_budget() {
  WorkLimits left = budget->limits();
  left.seconds = std::max(0.0, left.seconds - budget->seconds());
  left.comparisons -= std::min(left.comparisons, budget->comparisons());
  budget = std::make_unique<WorkBudget>(left);
}

void add_limits(py::module_& module) {
  blocks = PyContextVar_New("displayfile.limits", py::tuple().ptr());
  if (blocks == nullptr) throw py::error_already_set();
  py::class_<LimitsBlock, std::shared_ptr<LimitsBlock>>(module, "_LimitsBlock");
  module.def("_require_limits",
             [](py::handle pieces, py::handle comparisons, py::handle bytes, py::handle seconds) {
               limits_in(pieces, comparisons, bytes, seconds);
             });
  module.def("_ask_limits", [] {
    const NamedWork waiting(kWaiting);
    if (const auto block = block_in_force()) block->budget->ask();
  });
  module.def("_begin_limits", begin_limits);
  module.def("_end_limits", end_limits);
}

}  // namespace displayfile::python
