#include "clip/memory.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "clip/error.h"

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

}  // namespace

std::size_t offered_memory() {
  std::size_t offered = available_to_all();
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    offered = std::min<std::size_t>(offered, limit.rlim_cur);
  }
  return offered;
}

void out_of_memory(std::size_t bytes, const std::string& what) {
  throw Error(fmt::format("out of memory: {} needs at least {} bytes", what, bytes));
}

/// The system's pages are asked for, not the library's allocator: a compiler may leave out what is
/// allocated and released at once, and an application may count what it allocates.
bool has_memory(std::size_t bytes) {
  if (bytes < kWorthAsking) return true;
  void* const pages =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) return false;
  munmap(pages, bytes);
  return true;
}

}  // namespace displayfile
