#pragma once

#include <cstdint>
#include <functional>

namespace displayfile::bench {

/// The most bytes that operator new held at a time for the work, beyond what it held before, over
/// all threads: the working arrays and the result. Memory that a library takes otherwise (OSMesa,
/// GMP) is not in it. A count, the same in every run that allocates in the same order.
std::int64_t most_bytes_held(const std::function<void()>& work);

}  // namespace displayfile::bench
