#pragma once

#include <cstddef>
#include <functional>

namespace displayfile {

// The threads of in_parallel: from oneTBB (share_out_tbb.cpp), or without it from the C++ library
// (share_out_threads.cpp); in a browser there is one (share_out_alone.cpp).

/// The number of threads that this machine runs at a time; at least 1.
int most_threads();

/// Calls work(k) once for each k < count, in any order, on that many threads, this one among them;
/// threads and count are more than 1. Returns when all calls have; throws what one of them threw.
void share_out(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace displayfile
