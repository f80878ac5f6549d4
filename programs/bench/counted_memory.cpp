#include "programs/bench/counted_memory.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

// The program's own operator new and delete, so that what they hold can be counted. While nothing
// is counted they cost one load more than the library's.

namespace {

std::atomic<bool> counting = false;
std::atomic<std::int64_t> held = 0, most = 0;

void count(void* p, int sign) {
  if (!counting.load(std::memory_order_relaxed) || p == nullptr) return;
  const auto bytes = static_cast<std::int64_t>(malloc_usable_size(p));
  const std::int64_t now = held.fetch_add(sign * bytes) + sign * bytes;
  std::int64_t seen = most.load();
  while (now > seen && !most.compare_exchange_weak(seen, now)) {
  }
}

void* counted(void* p) {
  if (p == nullptr) throw std::bad_alloc();
  count(p, +1);
  return p;
}

void release(void* p) {
  count(p, -1);
  std::free(p);
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(std::malloc(std::max<std::size_t>(size, 1)));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto align = static_cast<std::size_t>(alignment);
  return counted(
      std::aligned_alloc(align, (std::max<std::size_t>(size, 1) + align - 1) / align * align));
}
void operator delete(void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }

namespace displayfile::bench {

std::int64_t most_bytes_held(const std::function<void()>& work) {
  held = most = 0;
  counting = true;
  try {
    work();
  } catch (...) {
    counting = false;
    throw;
  }
  counting = false;
  return most;
}

}  // namespace displayfile::bench
