#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace displayfile {

inline constexpr std::size_t kLeastInLargePages = std::size_t{16} << 20;

/// Advises the system, where supported, to back untouched memory with large pages; not worth it
/// below kLeastInLargePages.
inline void ask_for_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t kPage = 4096;
  if (bytes < kLeastInLargePages) return;
  const std::size_t past = reinterpret_cast<std::uintptr_t>(begin) % kPage;
  const std::size_t to_page = past == 0 ? 0 : kPage - past;
  ::madvise(static_cast<char*>(begin) + to_page, bytes - kPage, MADV_HUGEPAGE);  // or not
#endif
}

/// An array of copies of a value, in large pages. A gigabyte in small pages takes several times as
/// long to allocate, and a fifth of that again to free at exit, which could exceed a limit of
/// seconds.
template <class T>
std::vector<T> in_large_pages(std::size_t count, const T& value) {
  std::vector<T> values;
  values.reserve(count);
  ask_for_large_pages(values.data(), count * sizeof(T));
  values.assign(count, value);
  return values;
}

}  // namespace displayfile
