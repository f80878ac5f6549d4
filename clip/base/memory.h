#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <string>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"

namespace displayfile {

/// True if the system gives so much memory now. It is only asked for: nothing is written, and
/// nothing is kept. Little memory is not worth asking for.
bool has_memory(std::size_t bytes);

/// How many bytes a process may still take, as far as the system tells: what is free or can be made
/// so without writing to a disk, and no more than the process's own limit. What nothing limits is
/// the greatest number.
std::size_t offered_memory();
/// Part of what this process may have, lent to another process for as long as this lives:
/// has_memory allows so much less meanwhile, so that both together stay within the limit. It is
/// three quarters of what is left at most; a loan that would be smaller than wanted waits until
/// others have been given back, as long as the budget in force allows it. Without a limit all that
/// is wanted is lent. The system's limit is not changed: it is the host's.
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

/// What it has of that kind now; 0 if the system does not tell.
std::size_t memory_of_process();
/// What the machine has, or what this process may have of it at most; 0 if nothing tells.
std::size_t memory_of_machine();
/// How many bytes the budget in force allows, or the system allows this process (ulimit).
std::uint64_t bytes_allowed();
/// What is said of std::bad_alloc: the limit, what was being done, and what would serve instead.
std::string out_of_memory_message();

/// Throws LimitReached, which states the bytes and what needs them, and the limit if there is one.
[[noreturn]] void out_of_memory(std::size_t bytes, const std::string& what);

/// What `work` returns, which needs that many bytes at least: they are asked for first, so that
/// what cannot be done is known before any time is spent; where more is needed, and there is none,
/// it is the same Error. what() tells what they are for. Where so much is `held` already, it is not
/// asked for.
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

}  // namespace displayfile
