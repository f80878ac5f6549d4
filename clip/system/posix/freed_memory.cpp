#include "clip/system/freed_memory.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "clip/system/process_memory.h"

namespace displayfile {

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kLargest = 32 * 1024 * 1024;  // the most that it takes
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
  mallopt(M_MMAP_MAX, 0);         // large blocks, too, are taken from the one heap,
  mallopt(M_TRIM_THRESHOLD, -1);  // which keeps all that it has got
  void* const room = std::malloc(bytes + 2 * kPage);
  if (room == nullptr) return;
  const std::size_t to_page = kPage - reinterpret_cast<std::uintptr_t>(room) % kPage;
  ask_for_large_pages(static_cast<char*>(room) + to_page, bytes);
  std::free(room);
  // What comes before the first large page stays unused.
  constexpr std::size_t kOfAllocator = 64;
  static void* before = nullptr;
  if (before == nullptr && to_page > kOfAllocator) before = std::malloc(to_page - kOfAllocator);
#endif
}

}  // namespace displayfile
