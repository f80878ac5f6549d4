#include "interp/python/interrupts.h"

#include <atomic>
#include <chrono>

#include "clip/base/budgeted_work.h"
#include "clip/system/stopping.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

std::atomic<WorkBudget*> stopped_by_interrupt{nullptr};

void stop_work() noexcept {
  if (WorkBudget* const budget = stopped_by_interrupt.load()) budget->stop();
}

/// True if Python's interrupts, or another handler's, stop work from now on.
bool listen() { return stopped_by_interrupt.load() == nullptr && call_at_interrupts(stop_work); }

}  // namespace

/// Checked at each call: any thread may be the first to import the package, and after a fork the
/// thread that called it is the main one.
bool Caller::is_on_main_thread() {
  const py::module_ threading = py::module_::import("threading");
  const py::object main_thread = threading.attr("main_thread")();
  return py::object(main_thread.attr("ident")).equal(threading.attr("get_ident")());
}

StoppedByInterrupt::StoppedByInterrupt(const Caller& caller)
    : caller_(caller),
      budget_(caller.block ? caller.block->budget.get() : &own_),
      listens_(caller.is_main_thread && listen()),
      in_force_(budget_) {
  if (listens_) stopped_by_interrupt.store(budget_);
}

std::unique_lock<std::timed_mutex> turn_of(std::timed_mutex& mutex) {
  constexpr std::chrono::milliseconds kBetweenAsking{20};
  const NamedWork waiting(kWaiting);
  std::unique_lock turn(mutex, std::try_to_lock);
  while (!turn.owns_lock() && !turn.try_lock_for(kBetweenAsking)) ask_budget();
  return turn;
}

StoppedByInterrupt::~StoppedByInterrupt() {
  if (!listens_) return;
  call_at_interrupts_no_more();
  stopped_by_interrupt.store(nullptr);
  if (budget_ != &own_ && budget_->is_stopped()) caller_.block->renew_budget();
}

}  // namespace displayfile::python
