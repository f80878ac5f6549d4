#include "clip/base/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/system/process_memory.h"

namespace displayfile {

namespace {

constexpr std::size_t kWorthAsking = std::size_t{1} << 24;

std::atomic<std::size_t> lent{0};  // changed while `lending` is held

}  // namespace

std::size_t offered_memory() {
  return static_cast<std::size_t>(
      std::min<std::uint64_t>(memory_free_for_all(), limit_of_process()));
}

/// If more memory was allowed than the work is known to need, it ran out during the work: by the
/// process's limit, if there is one.
void out_of_memory(std::size_t bytes, const std::string& what) {
  const std::uint64_t allowed = bytes_allowed();
  const WorkDone left = NamedWork::left_by_exception();
  const std::string instead =
      left.instead == nullptr ? "" : std::string(", or ").append(left.instead);
  if (limit_of_process() != WorkLimits::kNone && bytes <= allowed) {
    throw LimitReached(
        fmt::format("out of memory: {}: {} bytes are not enough: expected a higher limit of "
                    "memory{}",
                    what, allowed, instead));
  }
  throw LimitReached(
      fmt::format("out of memory: {} needs at least {} bytes{}", what, bytes,
                  bytes <= allowed ? "" : fmt::format(", and the limit is {}", allowed)));
}

/// Requests pages from the system, not from the library's allocator: a compiler may omit memory
/// that is allocated and released at once, and an application may count its allocations.
bool has_memory(std::size_t bytes) {
  if (bytes < kWorthAsking) return true;
  if (const std::uint64_t limit = limit_of_data(); lent > 0 && limit != kNoMemoryLimit) {
    const std::size_t taken = memory_of_process() + lent;
    if (taken > limit || bytes > limit - taken) return false;
  }
  return can_have_pages(bytes);
}

// ---- The process --------------------------------------------------------------------------------

std::size_t memory_of_process() { return data_of_process(); }

std::size_t memory_of_machine() { return memory_of_groups(); }

namespace {

std::mutex lending;
std::condition_variable given_back;

/// Three quarters of the limit's unused rest.
std::size_t offer_of(std::uint64_t limit) {
  const std::size_t taken = memory_of_process() + lent;
  return limit > taken ? static_cast<std::size_t>(limit - taken) / 4 * 3 : 0;
}

}  // namespace

LentMemory::LentMemory(std::size_t wanted) : bytes_(wanted) {
  std::unique_lock lock(lending);
  std::uint64_t limit = limit_of_data();
  if (limit == kNoMemoryLimit) return;
  const auto is_enough = [&] {
    limit = limit_of_data();
    return lent == 0 || limit == kNoMemoryLimit || offer_of(limit) >= wanted;
  };
  constexpr std::chrono::milliseconds kWatch(20);
  while (!given_back.wait_for(lock, kWatch, is_enough)) ask_budget();
  if (limit == kNoMemoryLimit) return;
  bytes_ = std::min(wanted, offer_of(limit));
  is_lent_ = true;
  lent += bytes_;
}

LentMemory::~LentMemory() {
  if (!is_lent_) return;
  {
    const std::lock_guard lock(lending);
    lent -= bytes_;
  }
  given_back.notify_all();
}

std::uint64_t bytes_allowed() {
  const WorkBudget* const budget = work_in_force().budget;
  const std::uint64_t in_budget = budget == nullptr ? WorkLimits::kNone : budget->limits().bytes;
  return std::min(in_budget, limit_of_process());
}

std::string out_of_memory_message() {
  const auto [what, instead] = NamedWork::left_by_exception();
  std::string message = "out of memory";
  if (const std::uint64_t allowed = bytes_allowed(); allowed != WorkLimits::kNone) {
    message += fmt::format(" (the limit is {} bytes)", allowed);
  }
  if (what != nullptr) message.append(": ").append(what);
  message += ": expected more memory, or a higher limit of it";
  if (instead != nullptr) message.append(", or ").append(instead);
  return message;
}

}  // namespace displayfile
