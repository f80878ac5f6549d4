#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "clip/system/process_memory.h"

namespace displayfile {

/// True if the system can allocate this much memory now. Nothing is written or kept. Small amounts
/// are not checked.
bool has_memory(std::size_t bytes);

/// The bytes that this process may still allocate, as far as the system reports: free memory or
/// memory that can be freed without writing to a disk, up to the process's own limit. The maximum
/// if nothing limits it.
std::size_t offered_memory();
/// Part of this process's memory allowance, lent to another process during its lifetime: has_memory
/// allows less meanwhile, so that both stay within the limit. At most three quarters of the rest is
/// lent; a loan that would be smaller than requested waits until others are returned, within the
/// budget in force. Without a limit the full request is lent. The system's limit is not changed: it
/// is the host's.
class LentMemory {
 public:
  explicit LentMemory(std::size_t wanted);
  LentMemory(const LentMemory&) = delete;
  LentMemory& operator=(const LentMemory&) = delete;
  ~LentMemory();

  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_;
  bool is_lent_ = false;
};

/// This process's current memory of that kind; 0 if the system does not report it.
std::size_t memory_of_process();
/// The machine's memory, or this process's limit if lower; 0 if unknown.
std::size_t memory_of_machine();
/// The bytes allowed by the budget in force and by the system for this process (ulimit).
std::uint64_t bytes_allowed();
/// The message for std::bad_alloc: the limit, the current work, and an alternative.
std::string out_of_memory_message();

/// Throws LimitReached, with the bytes, their purpose, and the limit if any.
[[noreturn]] void out_of_memory(std::size_t bytes, const std::string& what);

/// Returns the result of `work`, which needs at least this many bytes. They are checked beforehand,
/// so that impossible work fails before any time is spent; running out of memory later gives the
/// same Error. what() names their purpose. The check is skipped if that much is already `held`.
template <class What, class Work>
auto with_memory(std::size_t bytes, What&& what, Work&& work, std::size_t held = 0) {
  NamedWork::begin_other();
  if (bytes > bytes_allowed()) out_of_memory(bytes, what());
  if (bytes > held && !has_memory(bytes)) out_of_memory(bytes, what());
  try {
    return work();
  } catch (const std::bad_alloc&) {
    out_of_memory(bytes, what());
  } catch (const std::length_error&) {
    out_of_memory(bytes, what());
  }
}

/// An array of copies of a value, in large pages. A gigabyte in small pages takes several times as
/// long to allocate, and a fifth of that again to free at exit, which could exceed a limit of
/// seconds.
template <class T>
std::vector<T> in_large_pages(std::size_t count, const T& value) {
  std::vector<T> values;
  values.reserve(count);
  ask_for_large_pages(values.data(), count * sizeof(T));
  values.assign(count, value);
  return values;
}

}  // namespace displayfile
