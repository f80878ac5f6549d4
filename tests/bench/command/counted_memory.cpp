#include "tests/bench/command/counted_memory.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <new>
#include <unordered_map>
#include <utility>

// The program's own operator new and delete, so that the memory they hold can be counted. While
// nothing is counted they cost one load more than the library's. All forms, though the library's
// others call these: under AddressSanitizer they do not.

namespace {

using displayfile::bench::CountedMemory;

/// For the table of blocks, which must not count itself.
template <class T>
struct Uncounted {
  using value_type = T;
  Uncounted() = default;
  template <class U>
  explicit Uncounted(const Uncounted<U>&) {}
  T* allocate(std::size_t n) {
    // NOLINTNEXTLINE(bugprone-sizeof-expression): a hash table allocates pointers too
    if (void* p = std::malloc(n * sizeof(T))) return static_cast<T*>(p);
    throw std::bad_alloc();
  }
  void deallocate(T* p, std::size_t) { std::free(p); }
  bool operator==(const Uncounted&) const { return true; }
};

/// The blocks that the counted work holds, with the requested sizes: malloc's own sizes depend on
/// earlier allocations.
class Blocks {
 public:
  void add(void* block, std::size_t size) {
    const std::scoped_lock lock(mutex_);
    sizes_.emplace(block, size);
    ++counted_.allocations;
    held_ += static_cast<std::int64_t>(size);
    counted_.most_bytes = std::max(counted_.most_bytes, held_);
  }
  void remove(void* block) {
    const std::scoped_lock lock(mutex_);
    const auto found = sizes_.find(block);
    if (found == sizes_.end()) return;  // from before
    held_ -= static_cast<std::int64_t>(found->second);
    sizes_.erase(found);
  }
  const CountedMemory& counted() const { return counted_; }
  std::int64_t held() {
    const std::scoped_lock lock(mutex_);
    return held_;
  }
  void clear() {
    sizes_.clear();
    held_ = 0;
    counted_ = {};
  }

 private:
  using Entry = std::pair<void* const, std::size_t>;
  std::mutex mutex_;
  std::unordered_map<void*, std::size_t, std::hash<void*>, std::equal_to<>, Uncounted<Entry>>
      sizes_;
  std::int64_t held_ = 0;
  CountedMemory counted_;
};

std::atomic<bool> counting = false;

Blocks& blocks() {
  static Blocks all;
  return all;
}

void* counted(void* p, std::size_t size) {
  if (p != nullptr && counting.load(std::memory_order_relaxed)) blocks().add(p, size);
  return p;
}

void* allocated(std::size_t size) {
  return counted(std::malloc(std::max<std::size_t>(size, 1)), size);
}

void* allocated(std::size_t size, std::align_val_t alignment) {
  const auto align = static_cast<std::size_t>(alignment);
  return counted(
      std::aligned_alloc(align, (std::max<std::size_t>(size, 1) + align - 1) / align * align),
      size);
}

void* found(void* p) {
  if (p == nullptr) throw std::bad_alloc();
  return p;
}

void release(void* p) {
  if (counting.load(std::memory_order_relaxed) && p != nullptr) blocks().remove(p);
  std::free(p);
}

}  // namespace

void* operator new(std::size_t n) { return found(allocated(n)); }
void* operator new[](std::size_t n) { return found(allocated(n)); }
void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return allocated(n); }
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return allocated(n); }
void* operator new(std::size_t n, std::align_val_t a) { return found(allocated(n, a)); }
void* operator new[](std::size_t n, std::align_val_t a) { return found(allocated(n, a)); }
void* operator new(std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept {
  return allocated(n, a);
}
void* operator new[](std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept {
  return allocated(n, a);
}
void operator delete(void* p) noexcept { release(p); }
void operator delete[](void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { release(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { release(p); }
void operator delete(void* p, std::align_val_t, const std::nothrow_t&) noexcept { release(p); }
void operator delete[](void* p, std::align_val_t, const std::nothrow_t&) noexcept { release(p); }

namespace displayfile::bench {

CountedMemory counted_memory(const std::function<void()>& work) {
  blocks().clear();
  counting = true;
  try {
    work();
  } catch (...) {
    counting = false;
    throw;
  }
  counting = false;
  return blocks().counted();
}

std::int64_t bytes_held_now() { return blocks().held(); }

}  // namespace displayfile::bench
