#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace displayfile {

/// How many of so many threads asked for this machine runs at a time; at least 1.
int useful_threads(int threads);

/// Calls work(k) once for each k < count, in any order, on up to useful_threads(threads) threads.
/// Returns when all calls have; throws what one of them threw.
void in_parallel(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

/// The same of any other function, without a copy of what it holds.
template <class Work>
void in_parallel(int threads, std::size_t count, const Work& work) {
  in_parallel(threads, count, std::function<void(std::size_t)>(std::cref(work)));
}

/// Calls work(k) for each k < size, where one call is little, many of them at a time to a thread.
template <class Work>
void in_even_parts(std::size_t size, int threads, const Work& work) {
  constexpr std::size_t kOfAPart = 2048;
  in_parallel(threads, (size + kOfAPart - 1) / kOfAPart, [&](std::size_t part) {
    const std::size_t end = std::min(size, (part + 1) * kOfAPart);
    for (std::size_t k = part * kOfAPart; k < end; ++k) work(static_cast<std::uint32_t>(k));
  });
}

}  // namespace displayfile
