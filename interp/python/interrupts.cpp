#include "interp/python/interrupts.h"

#include <atomic>
#include <thread>

#include "interp/python/limits.h"

namespace displayfile::python {

namespace {

std::thread::id main_thread;
std::atomic<WorkBudget*> stopped_by_interrupt{nullptr};
struct sigaction of_python {};

extern "C" void stop_and_tell_python(int signal) {
  if (WorkBudget* const budget = stopped_by_interrupt.load()) budget->stop();
  of_python.sa_handler(signal);
}

/// True if Python, or who else handles the signal, is told of it too from now on.
bool listen() {
  if (std::this_thread::get_id() != main_thread || stopped_by_interrupt.load() != nullptr) {
    return false;
  }
  if (sigaction(SIGINT, nullptr, &of_python) != 0) return false;
  const bool is_handled = (of_python.sa_flags & SA_SIGINFO) == 0 &&
                          of_python.sa_handler != SIG_DFL && of_python.sa_handler != SIG_IGN;
  if (!is_handled) return false;
  struct sigaction ours = of_python;
  ours.sa_handler = stop_and_tell_python;
  return sigaction(SIGINT, &ours, nullptr) == 0;
}

}  // namespace

void remember_main_thread() { main_thread = std::this_thread::get_id(); }

StoppedByInterrupt::StoppedByInterrupt()
    : budget_(budget_of_block() != nullptr ? budget_of_block() : &own_),
      listens_(listen()),
      in_force_(budget_) {
  if (listens_) stopped_by_interrupt.store(budget_);
}

StoppedByInterrupt::~StoppedByInterrupt() {
  if (!listens_) return;
  sigaction(SIGINT, &of_python, nullptr);
  stopped_by_interrupt.store(nullptr);
  if (budget_ != &own_ && budget_->is_stopped()) renew_budget_of_block();
}

}  // namespace displayfile::python
