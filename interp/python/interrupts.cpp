#include "interp/python/interrupts.h"

#include <atomic>
#include <chrono>

#include "clip/base/budgeted_work.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

std::atomic<WorkBudget*> stopped_by_interrupt{nullptr};
struct sigaction of_python {};

extern "C" void stop_and_tell_python(int signal) {
  if (WorkBudget* const budget = stopped_by_interrupt.load()) budget->stop();
  of_python.sa_handler(signal);
}

/// True if Python, or who else handles the signal, is told of it too from now on.
bool listen() {
  if (stopped_by_interrupt.load() != nullptr) return false;
  if (sigaction(SIGINT, nullptr, &of_python) != 0) return false;
  const bool is_handled = (of_python.sa_flags & SA_SIGINFO) == 0 &&
                          of_python.sa_handler != SIG_DFL && of_python.sa_handler != SIG_IGN;
  if (!is_handled) return false;
  struct sigaction ours = of_python;
  ours.sa_handler = stop_and_tell_python;
  return sigaction(SIGINT, &ours, nullptr) == 0;
}

}  // namespace

/// Asked each time: any thread may be the first to import the package, and after a fork the thread
/// that called it is the main one.
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
  sigaction(SIGINT, &of_python, nullptr);
  stopped_by_interrupt.store(nullptr);
  if (budget_ != &own_ && budget_->is_stopped()) caller_.block->renew_budget();
}

}  // namespace displayfile::python
