#include "clip/memory.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include "clip/error.h"

namespace displayfile {

namespace {

constexpr std::size_t kWorthAsking = std::size_t{1} << 24;

}  // namespace

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
