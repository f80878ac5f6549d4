#pragma once

#include <cstddef>
#include <functional>

namespace displayfile {

// How in_parallel uses threads: by oneTBB (share_out_tbb.cpp) or, in a build without it, by threads
// of the C++ library (share_out_threads.cpp); in a browser there is one (share_out_alone.cpp).

/// How many threads this machine runs at a time; at least 1.
int most_threads();

/// Calls work(k) once for each k < count, in any order, on that many threads, this one among them;
/// threads and count are more than 1. Returns when all calls have; throws what one of them threw.
void share_out(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace displayfile
