#include "clip/base/memory.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <fstream>
#include <limits>
#include <mutex>
#include <optional>
#include <string>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"

namespace displayfile {

namespace {

constexpr std::size_t kWorthAsking = std::size_t{1} << 24;

/// Linux says it in kibibytes; other systems say nothing here.
std::size_t available_to_all() {
  std::ifstream file("/proc/meminfo");
  for (std::string name; file >> name;) {
    std::size_t kibibytes = 0;
    if (name == "MemAvailable:" && file >> kibibytes) return kibibytes * 1024;
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::numeric_limits<std::size_t>::max();
}

std::atomic<std::size_t> lent{0};  // changed while `lending` is held

/// The least that the system limits this process to, of data or of addresses.
std::uint64_t limit_of_process() {
  std::uint64_t least = WorkLimits::kNone;
  for (const auto kind : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limit{};
    if (::getrlimit(kind, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
      least = std::min<std::uint64_t>(least, limit.rlim_cur);
    }
  }
  return least;
}

/// The limit of data; nothing if there is none.
std::optional<rlimit> limit_of_data() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
  return limit;
}

/// A word of the file as a number of bytes; 0 if it is none.
std::size_t number_in(const char* file, int words_before) {
  std::ifstream in(file);
  std::string word;
  for (int k = 0; k < words_before; ++k) in >> word;
  std::size_t number = 0;
  return in >> number ? number : 0;
}

/// The least that the groups of this process (cgroup) are limited to, from its own to the root.
/// Those of version 2 have no list of controllers.
std::uint64_t limit_of_groups() {
  std::uint64_t least = WorkLimits::kNone;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {  // NUMBER:CONTROLLERS:/PATH
    const std::size_t list = line.find(':') + 1, path = line.find(":/", list) + 1;
    if (list == 0 || path == 0) continue;
    const bool is_second = path == list + 1;
    if (!is_second && line.substr(list, path - 1 - list) != "memory") continue;
    const std::string root = is_second ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    const char* const file = is_second ? "/memory.max" : "/memory.limit_in_bytes";
    std::string group = line.substr(path);
    for (;;) {
      if (const std::size_t limit = number_in((root + group + file).c_str(), 0); limit != 0) {
        least = std::min<std::uint64_t>(least, limit);
      }
      if (group.empty()) break;
      group.resize(group.rfind('/'));
    }
  }
  return least;
}

std::size_t page() { return static_cast<std::size_t>(std::max(1L, ::sysconf(_SC_PAGESIZE))); }

}  // namespace

std::size_t offered_memory() {
  return static_cast<std::size_t>(std::min<std::uint64_t>(available_to_all(), limit_of_process()));
}

/// Where more was allowed than what is known to be needed, it ran out in the middle of the work: by
/// the limit of the process, if it has one.
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

/// The system's pages are asked for, not the library's allocator: a compiler may leave out what is
/// allocated and released at once, and an application may count what it allocates.
bool has_memory(std::size_t bytes) {
  if (bytes < kWorthAsking) return true;
  if (const auto limit = limit_of_data(); lent > 0 && limit) {
    const std::size_t taken = memory_of_process() + lent;
    if (taken > limit->rlim_cur || bytes > limit->rlim_cur - taken) return false;
  }
  void* const pages =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) return false;
  munmap(pages, bytes);
  return true;
}

// ---- The process --------------------------------------------------------------------------------

/// Data: what it may write to, but for shared memory; the sixth of the kernel's numbers.
std::size_t memory_of_process() { return page() * number_in("/proc/self/statm", 5); }

std::size_t memory_of_machine() {
  const std::size_t all =
      page() * static_cast<std::size_t>(std::max(0L, ::sysconf(_SC_PHYS_PAGES)));
  return static_cast<std::size_t>(std::min<std::uint64_t>(all, limit_of_groups()));
}

namespace {

std::mutex lending;
std::condition_variable given_back;

/// Three quarters of what is left of it.
std::size_t offer_of(const rlimit& limit) {
  const std::size_t taken = memory_of_process() + lent;
  return limit.rlim_cur > taken ? static_cast<std::size_t>(limit.rlim_cur - taken) / 4 * 3 : 0;
}

}  // namespace

LentMemory::LentMemory(std::size_t wanted) : bytes_(wanted) {
  std::unique_lock lock(lending);
  std::optional<rlimit> limit = limit_of_data();
  if (!limit) return;
  const auto is_enough = [&] {
    limit = limit_of_data();
    return lent == 0 || !limit || offer_of(*limit) >= wanted;
  };
  constexpr std::chrono::milliseconds kWatch(20);
  while (!given_back.wait_for(lock, kWatch, is_enough)) ask_budget();
  if (!limit) return;
  bytes_ = std::min(wanted, offer_of(*limit));
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
