#pragma once

#include <cstdint>
#include <functional>

namespace displayfile::bench {

/// The memory that operator new gave to some work, over all threads.
struct CountedMemory {
  std::int64_t most_bytes = 0;   ///< held at a time, beyond the bytes held before
  std::int64_t allocations = 0;  ///< calls of it
};

/// The working arrays and the result. Memory that a library takes otherwise (OSMesa, GMP) is not in
/// it. Counts, the same in every run that allocates in the same order.
CountedMemory counted_memory(const std::function<void()>& work);

/// The most bytes that counted_memory counts as held.
inline std::int64_t most_bytes_held(const std::function<void()>& work) {
  return counted_memory(work).most_bytes;
}

/// Within the work that counted_memory counts: the bytes held now, beyond those held before.
std::int64_t bytes_held_now();

}  // namespace displayfile::bench
