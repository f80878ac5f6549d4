#include "clip/system/process_memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <span>
#include <string>

namespace displayfile {

namespace {

/// The number after that many words of the file; 0 if there is none.
std::size_t number_in(const char* file, int words_before) {
  std::ifstream in(file);
  std::string word;
  for (int k = 0; k < words_before; ++k) in >> word;
  std::size_t number = 0;
  return in >> number ? number : 0;
}

/// The lowest limit of this process's control groups (cgroup), from its own to the root. Groups of
/// version 2 have no list of controllers.
std::uint64_t limit_of_groups() {
  std::uint64_t least = kNoMemoryLimit;
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

/// Linux reports it in kibibytes; other systems report nothing here.
std::size_t memory_free_for_all() {
  std::ifstream file("/proc/meminfo");
  for (std::string name; file >> name;) {
    std::size_t kibibytes = 0;
    if (name == "MemAvailable:" && file >> kibibytes) return kibibytes * 1024;
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::numeric_limits<std::size_t>::max();
}

/// The writable memory, except for shared memory: the sixth number in statm.
std::size_t data_of_process() { return page() * number_in("/proc/self/statm", 5); }

std::size_t memory_of_groups() {
  const std::size_t all =
      page() * static_cast<std::size_t>(std::max(0L, ::sysconf(_SC_PHYS_PAGES)));
  return static_cast<std::size_t>(std::min<std::uint64_t>(all, limit_of_groups()));
}

std::uint64_t limit_of_data() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
    return kNoMemoryLimit;
  }
  return limit.rlim_cur;
}

std::uint64_t limit_of_process() {
  rlimit limit{};
  const std::uint64_t least = limit_of_data();
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return least;
  return std::min<std::uint64_t>(least, limit.rlim_cur);
}

/// RLIMIT_DATA counts the private writable memory that is mapped: unlike the address space, it
/// excludes memory that is only reserved, and unlike resident memory, it cannot be exceeded.
void set_limit_of_data(std::uint64_t bytes) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min({static_cast<rlim_t>(bytes), limit.rlim_cur, limit.rlim_max});
  ::setrlimit(RLIMIT_DATA, &limit);
}

bool can_have_pages(std::size_t bytes) {
  void* const pages =
      ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) return false;
  ::munmap(pages, bytes);
  return true;
}

void ask_for_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t kPage = 4096;
  if (bytes < kLeastInLargePages) return;
  const std::size_t past = reinterpret_cast<std::uintptr_t>(begin) % kPage;
  const std::size_t to_page = past == 0 ? 0 : kPage - past;
  ::madvise(static_cast<char*>(begin) + to_page, bytes - kPage, MADV_HUGEPAGE);  // or not
#endif
}

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kLargest = 32 * 1024 * 1024;  // the largest threshold that mallopt accepts
  mallopt(M_MMAP_THRESHOLD, kLargest);
  mallopt(M_TRIM_THRESHOLD, 8 * kLargest);
  mallopt(M_TOP_PAD, kLargest / 2);
#endif
}

void ask_for_memory([[maybe_unused]] std::size_t bytes) {
#if defined(__GLIBC__) && defined(MADV_POPULATE_WRITE)
  constexpr std::size_t kPiece = std::size_t{8} << 20, kPage = 4096;
  std::array<void*, 32> room{};
  const std::span pieces = std::span(room).first(std::min(bytes / kPiece, room.size()));
  for (void*& piece : pieces) {
    piece = std::malloc(kPiece);
    if (piece == nullptr) break;
    const std::size_t to_page = kPage - reinterpret_cast<std::uintptr_t>(piece) % kPage;
    madvise(static_cast<char*>(piece) + to_page, kPiece - kPage, MADV_POPULATE_WRITE);  // or not
  }
  for (void* piece : pieces) std::free(piece);
#endif
}

void hand_out_large_pages([[maybe_unused]] std::size_t bytes) {
#ifdef __GLIBC__
  constexpr std::size_t kPage = std::size_t{2} << 20;
  if (bytes < kLeastInLargePages) return;
  mallopt(M_MMAP_MAX, 0);         // large blocks are also taken from the heap,
  mallopt(M_TRIM_THRESHOLD, -1);  // which keeps all its memory
  void* const room = std::malloc(bytes + 2 * kPage);
  if (room == nullptr) return;
  const std::size_t to_page = kPage - reinterpret_cast<std::uintptr_t>(room) % kPage;
  ask_for_large_pages(static_cast<char*>(room) + to_page, bytes);
  std::free(room);
  // The memory before the first large page stays unused.
  constexpr std::size_t kOfAllocator = 64;
  static void* before = nullptr;
  if (before == nullptr && to_page > kOfAllocator) before = std::malloc(to_page - kOfAllocator);
#endif
}

}  // namespace displayfile
