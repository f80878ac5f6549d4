#pragma once

namespace displayfile {

/// From now on an interrupt from the keyboard (SIGINT) calls `first`, and then the handler that the
/// process had. False, without an effect, if it had none or ignored it.
bool call_at_interrupts(void (*first)() noexcept);
/// That handler alone is called again.
void call_at_interrupts_no_more();

}  // namespace displayfile
