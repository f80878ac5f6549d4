#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace displayfile {

/// The number of threads, of those requested, that this machine can run at a time; at least 1.
int useful_threads(int threads);

/// Calls work(k) once for each k < count, in any order, on up to useful_threads(threads) threads.
/// Returns when all calls have; throws what one of them threw.
void in_parallel(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

/// The same for any callable, without copying it.
template <class Work>
void in_parallel(int threads, std::size_t count, const Work& work) {
  in_parallel(threads, count, std::function<void(std::size_t)>(std::cref(work)));
}

/// Calls work(k) for each k < size, for short calls, in batches per thread.
template <class Work>
void in_even_parts(std::size_t size, int threads, const Work& work) {
  constexpr std::size_t kOfAPart = 2048;
  in_parallel(threads, (size + kOfAPart - 1) / kOfAPart, [&](std::size_t part) {
    const std::size_t end = std::min(size, (part + 1) * kOfAPart);
    for (std::size_t k = part * kOfAPart; k < end; ++k) work(static_cast<std::uint32_t>(k));
  });
}

// The threads of in_parallel: from oneTBB (share_out_tbb.cpp), or without it from the C++ library
// (share_out_threads.cpp); in a browser there is one (share_out_alone.cpp).

/// The number of threads that this machine runs at a time; at least 1.
int most_threads();

/// Calls work(k) once for each k < count, in any order, on that many threads, this one among them;
/// threads and count are more than 1. Returns when all calls have; throws what one of them threw.
void share_out(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace displayfile
