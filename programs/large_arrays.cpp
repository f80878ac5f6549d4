// Large arrays of the command lie in large pages, where the system has them for who asks: a mesh of
// a million triangles takes hundreds of megabytes, which the kernel otherwise hands out and clears
// in pieces of 4 KiB, a third of the time of its picture.

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;  // bytes; 2 MiB almost everywhere
constexpr std::size_t kLargeArray = 2 * kLargePage;       // smaller ones are not worth it

/// Null if there is no memory.
void* allocated(std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  if (bytes >= kLargeArray && bytes <= static_cast<std::size_t>(-1) - kLargePage) {
    const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    void* const memory = std::aligned_alloc(kLargePage, whole);
    if (memory != nullptr) madvise(memory, whole, MADV_HUGEPAGE);  // it is only advice
    return memory;
  }
#endif
  return std::malloc(bytes > 0 ? bytes : 1);
}

}  // namespace

void* operator new(std::size_t bytes) {
  for (;;) {
    if (void* const memory = allocated(bytes)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
