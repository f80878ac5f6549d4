#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <ctime>
#include <new>

#include "clip/system/stopping.h"

namespace displayfile {

namespace {

void (*last_when_stopped)() noexcept = nullptr;
void (*last_in_time)() noexcept = nullptr;
/// The message at the time limit; a signal handler reads it.
std::array<char, 256> time_is_over{};
std::size_t time_is_over_length = 0;

/// SA_RESETHAND has restored the signal's default action by then.
void on_stop(int signal) {
  last_when_stopped();
  std::raise(signal);
}

void on_time_over(int /*signal*/) {
  last_in_time();
  if (::write(STDERR_FILENO, time_is_over.data(), time_is_over_length) < 0) ::_exit(2);
  ::_exit(2);
}

void set_timer(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds))) + (seconds > 0.0 ? 1 : 0);
  if (timer.it_value.tv_usec >= 1'000'000) timer.it_value.tv_usec = 999'999;
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace

HeldSignals::HeldSignals() : before_() {
  static_assert(sizeof(sigset_t) <= sizeof before_);
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, new (before_.data()) sigset_t);
}

HeldSignals::~HeldSignals() {
  const auto* const before = std::launder(reinterpret_cast<const sigset_t*>(before_.data()));
  ::pthread_sigmask(SIG_SETMASK, before, nullptr);
}

void wait_a_millisecond() noexcept {
  constexpr timespec kMillisecond{0, 1'000'000};
  ::nanosleep(&kMillisecond, nullptr);
}

void wait_for_the_end() noexcept {
  while (true) ::pause();
}

void call_when_stopped(void (*last)() noexcept) {
  last_when_stopped = last;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = on_stop;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(signal, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);  // writes then fail with an error, like on a full disk
}

void end_process_after(double seconds, const std::string& message, void (*last)() noexcept) {
  last_in_time = last;
  time_is_over_length = std::min(message.size(), time_is_over.size());
  std::copy_n(message.data(), time_is_over_length, time_is_over.data());
  struct sigaction action {};
  action.sa_handler = on_time_over;
  ::sigaction(SIGALRM, &action, nullptr);
  sigset_t alarm;  // the parent process may have blocked it
  ::sigemptyset(&alarm);
  ::sigaddset(&alarm, SIGALRM);
  ::pthread_sigmask(SIG_UNBLOCK, &alarm, nullptr);
  set_timer(seconds);
}

void end_process_no_more() { set_timer(0.0); }

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
