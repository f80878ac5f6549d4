#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace displayfile {

/// Blocks signals on this thread during its lifetime; no effect where the system stops a program on
/// another thread.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

 private:
  alignas(std::max_align_t) std::array<std::byte, 128> before_;
};

/// Both for signal handlers: waits for about a millisecond; waits for the end of the process, which
/// another thread brings about.
void wait_a_millisecond() noexcept;
[[noreturn]] void wait_for_the_end() noexcept;

/// From now on `last` is called when the process is stopped from outside, and then the process ends
/// as usual: by the signals INT, TERM, HUP, QUIT, PIPE and XCPU, or as a console stops it. Signals
/// ignored at process start stay ignored. Exceeding the file size limit is an error like a full
/// disk, and no signal.
void call_when_stopped(void (*last)() noexcept);

/// Ends the process after `seconds`, at most 1e9: `last` is called, the message, which has
/// at most 255 bytes, written to standard error, and the exit status is 2. No more than one at a
/// time.
void end_process_after(double seconds, const std::string& message, void (*last)() noexcept);
/// Cancels end_process_after.
void end_process_no_more();

/// From now on an interrupt from the keyboard (SIGINT) calls `first`, and then the handler that the
/// process had. False, without an effect, if it had none or ignored it.
bool call_at_interrupts(void (*first)() noexcept);
/// Restores that handler.
void call_at_interrupts_no_more();

}  // namespace displayfile
