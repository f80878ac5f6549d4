#pragma once

#include <cstddef>
#include <vector>

#include "clip/system/process_memory.h"

namespace displayfile {

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
