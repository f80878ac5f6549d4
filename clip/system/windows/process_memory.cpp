#include "clip/system/process_memory.h"

#include <algorithm>
#include <atomic>

#include "clip/system/windows/windows.h"
// Must be included after windows.h.
#include <psapi.h>

namespace displayfile {

namespace {

/// The limit that this process has set itself.
std::atomic<std::uint64_t> own_limit{kNoMemoryLimit};

MEMORYSTATUSEX state_of_memory() {
  MEMORYSTATUSEX state{};
  state.dwLength = sizeof state;
  ::GlobalMemoryStatusEx(&state);
  return state;
}

}  // namespace

std::size_t memory_free_for_all() {
  const auto free = static_cast<std::size_t>(state_of_memory().ullAvailPhys);
  return free == 0 ? std::numeric_limits<std::size_t>::max() : free;
}

std::size_t data_of_process() {
  PROCESS_MEMORY_COUNTERS_EX counts{};
  counts.cb = sizeof counts;
  if (::K32GetProcessMemoryInfo(::GetCurrentProcess(),
                                reinterpret_cast<PROCESS_MEMORY_COUNTERS*>(&counts),
                                sizeof counts) == 0) {
    return 0;
  }
  return std::max(counts.PrivateUsage, counts.PagefileUsage);  // the same, if both are known
}

std::size_t memory_of_groups() { return static_cast<std::size_t>(state_of_memory().ullTotalPhys); }

std::uint64_t limit_of_data() { return own_limit; }

std::uint64_t limit_of_process() { return own_limit; }

/// Limits the committed memory of a job that contains only this process.
void set_limit_of_data(std::uint64_t bytes) {
  static const HANDLE job = ::CreateJobObjectW(nullptr, nullptr);
  const std::uint64_t least = std::min(bytes, own_limit.load());
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_PROCESS_MEMORY;
  limits.ProcessMemoryLimit = static_cast<SIZE_T>(least);
  if (::SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits) ==
      0) {
    return;
  }
  static const bool is_in_job = ::AssignProcessToJobObject(job, ::GetCurrentProcess()) != 0;
  if (is_in_job) own_limit = least;
}

bool can_have_pages(std::size_t bytes) {
  if (const std::uint64_t limit = own_limit; limit != kNoMemoryLimit) {
    const std::size_t taken = data_of_process();
    if (taken > limit || bytes > limit - taken) return false;
  }
  void* const pages = ::VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
  if (pages == nullptr) return false;
  ::VirtualFree(pages, 0, MEM_RELEASE);
  return true;
}

/// Large pages require a privilege that users do not have.
void ask_for_large_pages(void* /*begin*/, std::size_t /*bytes*/) {}

// This C library has no equivalent settings.

void keep_freed_memory() {}

void ask_for_memory(std::size_t /*bytes*/) {}

void hand_out_large_pages(std::size_t /*bytes*/) {}

}  // namespace displayfile
