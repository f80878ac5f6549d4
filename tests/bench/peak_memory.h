#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace displayfile::bench {

/// The resident memory of this process at its peak while the work is done, less what it was
/// before, in bytes: what the system counts (VmHWM and VmRSS in /proc/self/status, the peak reset
/// through /proc/self/clear_refs), so that every allocation, thread and library is in it. To be
/// asked in a process of its own, that freed nothing much before. Nothing on a system that does
/// not tell.
std::optional<std::size_t> peak_bytes(const std::function<void()>& work);

}  // namespace displayfile::bench
