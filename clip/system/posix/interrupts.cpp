#include "clip/system/interrupts.h"

#include <csignal>

namespace displayfile {

namespace {

void (*called_first)() noexcept = nullptr;
struct sigaction of_process {};

void on_interrupt(int signal) {
  called_first();
  of_process.sa_handler(signal);
}

}  // namespace

bool call_at_interrupts(void (*first)() noexcept) {
  if (::sigaction(SIGINT, nullptr, &of_process) != 0) return false;
  const bool is_handled = (of_process.sa_flags & SA_SIGINFO) == 0 &&
                          of_process.sa_handler != SIG_DFL && of_process.sa_handler != SIG_IGN;
  if (!is_handled) return false;
  called_first = first;
  struct sigaction ours = of_process;
  ours.sa_handler = on_interrupt;
  return ::sigaction(SIGINT, &ours, nullptr) == 0;
}

void call_at_interrupts_no_more() { ::sigaction(SIGINT, &of_process, nullptr); }

}  // namespace displayfile
