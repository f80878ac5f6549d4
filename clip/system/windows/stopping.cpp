#include <io.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>

#include "clip/system/stopping.h"
#include "clip/system/windows/windows.h"

namespace displayfile {

namespace {

std::atomic<void (*)() noexcept> last_when_stopped{nullptr};
std::atomic<void (*)() noexcept> last_in_time{nullptr};
std::string time_is_over;
HANDLE timer = nullptr;

/// Called on a system thread. The default handling follows and ends the process.
BOOL WINAPI on_stop(DWORD /*event*/) {
  last_when_stopped.load()();
  return FALSE;
}

/// Also called on a system thread.
void CALLBACK on_time_over(void* /*nothing*/, BOOLEAN /*fired*/) {
  constexpr int kStandardError = 2;
  last_in_time.load()();
  ::_write(kStandardError, time_is_over.data(), static_cast<unsigned>(time_is_over.size()));
  ::_exit(2);
}

}  // namespace

HeldSignals::HeldSignals() : before_() {}

HeldSignals::~HeldSignals() = default;

void wait_a_millisecond() noexcept { ::Sleep(1); }

void wait_for_the_end() noexcept {
  while (true) ::Sleep(INFINITE);
}

void call_when_stopped(void (*last)() noexcept) {
  last_when_stopped = last;
  ::SetConsoleCtrlHandler(on_stop, TRUE);
}

/// The system's timers count milliseconds; 32 bits of them are 49 days.
void end_process_after(double seconds, const std::string& message, void (*last)() noexcept) {
  constexpr double kLongest = 4e9;
  end_process_no_more();
  last_in_time = last;
  time_is_over = message;
  ::CreateTimerQueueTimer(&timer, nullptr, on_time_over, nullptr,
                          static_cast<DWORD>(std::min(1000.0 * seconds + 1.0, kLongest)), 0,
                          WT_EXECUTEONLYONCE);
}

void end_process_no_more() {
  if (timer == nullptr) return;
  // Waits for a running callback, which ends the process.
  ::DeleteTimerQueueTimer(nullptr, timer, INVALID_HANDLE_VALUE);
  timer = nullptr;
}

namespace {

using Handler = void (*)(int);

std::atomic<void (*)() noexcept> called_first{nullptr};
std::atomic<Handler> of_process{nullptr};

/// Called on a system thread. A call resets the handler, so it is installed again.
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
