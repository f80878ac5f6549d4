#include "clip/system/interrupts.h"

#include <atomic>
#include <csignal>

namespace displayfile {

namespace {

using Handler = void (*)(int);

std::atomic<void (*)() noexcept> called_first{nullptr};
std::atomic<Handler> of_process{nullptr};

/// A handler is called once here, on a thread of the system's, and then no more.
void on_interrupt(int signal) {
  std::signal(SIGINT, on_interrupt);
  called_first.load()();
  of_process.load()(signal);
}

}  // namespace

bool call_at_interrupts(void (*first)() noexcept) {
  called_first = first;
  const Handler before = std::signal(SIGINT, SIG_IGN);
  const bool is_handled = before != SIG_DFL && before != SIG_IGN && before != SIG_ERR;
  of_process = before;
  std::signal(SIGINT, is_handled ? on_interrupt : before);
  return is_handled;
}

void call_at_interrupts_no_more() { std::signal(SIGINT, of_process); }

}  // namespace displayfile
