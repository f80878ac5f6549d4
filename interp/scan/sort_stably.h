#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace displayfile {

/// Stable sort by a key: the drawing must not depend on the standard library's sort. Allocates no
/// memory for few or sorted elements.
template <class Array, class Key>
void sort_stably(Array&& array, Key key) {
  constexpr std::size_t kFew = 16;
  const auto before = [&](const auto& a, const auto& b) {
    return std::invoke(key, a) < std::invoke(key, b);
  };
  if (array.size() > kFew && !std::is_sorted(array.begin(), array.end(), before)) {
    std::ranges::stable_sort(array.begin(), array.end(), before);
    return;
  }
  for (std::size_t i = 1; i < array.size(); ++i) {
    for (std::size_t k = i; k > 0 && before(array[k], array[k - 1]); --k) {
      std::swap(array[k], array[k - 1]);
    }
  }
}

}  // namespace displayfile
