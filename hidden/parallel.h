#pragma once

#include <cstddef>
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

}  // namespace displayfile
