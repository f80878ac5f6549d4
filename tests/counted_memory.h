#pragma once

#include <cstddef>
#include <functional>

namespace displayfile::test {

/// The memory taken with new, at its peak while the work is done, less what was taken before; in
/// bytes, the same in every run of one thread. For programs that are linked with
/// counted_memory.cpp, which replaces new and delete.
std::size_t peak_of_new(const std::function<void()>& work);

}  // namespace displayfile::test
