#include "hidden/exact/predicate_counts.h"

#include <atomic>
#include <cassert>
#include <mutex>
#include <vector>

namespace displayfile {

namespace {

constexpr std::array<std::string_view, kPredicates> kNames = {
    "orientation-2",  "orientation-3",  "row",         "crossing",
    "side-of-plane",  "side-of-line",   "compare",     "depth-at-pixel",
    "depth-at-point", "line-parameter", "within-reach"};

/// Written by one thread, read by any.
struct ThreadCounts {
  std::array<std::atomic<std::uint64_t>, 2 * kPredicates> count{};

  void add_one(std::size_t k) {
    count[k].store(count[k].load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
};

void add(PredicateCounts& sum, const ThreadCounts& counts) {
  for (std::size_t k = 0; k < kPredicates; ++k) {
    sum[k].by_definition += counts.count[2 * k].load(std::memory_order_relaxed);
    sum[k].exact += counts.count[2 * k + 1].load(std::memory_order_relaxed);
  }
}

/// The threads that have counted, the counts of ended threads, and the counts at the last reset.
struct Register {
  std::mutex mutex;
  std::vector<const ThreadCounts*> threads;
  PredicateCounts ended{};
  PredicateCounts at_reset{};

  PredicateCounts total() const {
    PredicateCounts sum = ended;
    for (const ThreadCounts* counts : threads) add(sum, *counts);
    return sum;
  }
};

// Never destroyed: a thread may end after the program's statics are gone.
Register& the_register() {
  static auto* const counts = new Register;
  return *counts;
}

struct RegisteredCounts : ThreadCounts {
  RegisteredCounts() {
    Register& all = the_register();
    const std::lock_guard lock(all.mutex);
    all.threads.push_back(this);
  }
  RegisteredCounts(const RegisteredCounts&) = delete;
  RegisteredCounts& operator=(const RegisteredCounts&) = delete;
  ~RegisteredCounts() {
    Register& all = the_register();
    const std::lock_guard lock(all.mutex);
    add(all.ended, *this);
    std::erase(all.threads, this);
  }
};

thread_local RegisteredCounts counts_of_thread;

}  // namespace

std::string_view name_of(Predicate predicate) {
  assert(static_cast<std::size_t>(predicate) < kNames.size());
  return kNames[static_cast<std::size_t>(predicate)];
}

PredicateCounts predicate_counts() {
  Register& all = the_register();
  const std::lock_guard lock(all.mutex);
  PredicateCounts sum = all.total();
  for (std::size_t k = 0; k < kPredicates; ++k) {
    sum[k].by_definition -= all.at_reset[k].by_definition;
    sum[k].exact -= all.at_reset[k].exact;
  }
  return sum;
}

void reset_predicate_counts() {
  Register& all = the_register();
  const std::lock_guard lock(all.mutex);
  all.at_reset = all.total();
}

void count_by_definition(Predicate predicate) {
  counts_of_thread.add_one(2 * static_cast<std::size_t>(predicate));
}

void count_exact(Predicate predicate) {
  counts_of_thread.add_one(2 * static_cast<std::size_t>(predicate) + 1);
}

}  // namespace displayfile
