#pragma once

// A standard library that uses its freedom. The standard leaves open the order of equals after
// std::sort, that of the elements on either side after std::nth_element, of either part after
// std::partition, and which of equals is on top of a heap; each library does it in its own way,
// always the same. Here each is done at random, by the seed in the environment variable
// OTHER_LIBRARY_SEED. Forced before all else (-include), it shows results that depend on the
// library: tests/deep compares them.

#if __cplusplus > 201703L  // the test compiler of CMake's checks is older

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <list>
#include <ranges>
#include <utility>

namespace other_library {

inline std::uint64_t seed() {
  const char* text = std::getenv("OTHER_LIBRARY_SEED");
  return text == nullptr ? 1 : std::strtoull(text, nullptr, 10);
}

/// SplitMix64, as in programs/scenes/random.h.
inline std::uint64_t next_random() {
  thread_local std::uint64_t state = seed();
  std::uint64_t z = state += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

template <class Iterator>
void shuffle(Iterator first, Iterator last) {
  for (auto n = last - first; n > 1; --n) {
    const auto k = next_random() % static_cast<std::uint64_t>(n);
    std::ranges::iter_swap(first + (n - 1), first + static_cast<decltype(n)>(k));
  }
}

/// Larger heaps stay as they are, for the time's sake.
inline constexpr std::ptrdiff_t kLargestHeapShuffled = 64;

template <class Iterator, class... Compare>
void rebuild_heap(Iterator first, Iterator last, Compare... compare) {
  if (last - first > kLargestHeapShuffled) return;
  shuffle(first, last);
  std::make_heap(first, last, compare...);
}

}  // namespace other_library

namespace std {

template <class Iterator, class... Compare>
void other_sort(Iterator first, Iterator last, Compare... compare) {
  other_library::shuffle(first, last);
  sort(first, last, compare...);
}

template <class Iterator, class... Compare>
void other_partial_sort(Iterator first, Iterator middle, Iterator last, Compare... compare) {
  other_library::shuffle(first, last);
  partial_sort(first, middle, last, compare...);
  other_library::shuffle(middle, last);
}

template <class Iterator, class... Compare>
void other_nth_element(Iterator first, Iterator nth, Iterator last, Compare... compare) {
  other_library::shuffle(first, last);
  nth_element(first, nth, last, compare...);
  other_library::shuffle(first, nth);
  if (nth != last) other_library::shuffle(nth + 1, last);
}

template <class Iterator, class Predicate>
Iterator other_partition(Iterator first, Iterator last, Predicate predicate) {
  const Iterator middle = partition(first, last, predicate);
  other_library::shuffle(first, middle);
  other_library::shuffle(middle, last);
  return middle;
}

template <class Iterator, class... Compare>
void other_push_heap(Iterator first, Iterator last, Compare... compare) {
  push_heap(first, last, compare...);
  other_library::rebuild_heap(first, last, compare...);
}

template <class Iterator, class... Compare>
void other_pop_heap(Iterator first, Iterator last, Compare... compare) {
  pop_heap(first, last, compare...);
  if (first != last) other_library::rebuild_heap(first, last - 1, compare...);
}

namespace ranges {

struct OtherSort {
  template <class Range, class Compare = less, class Projection = identity>
  auto operator()(Range&& range, Compare compare = {}, Projection projection = {}) const {
    other_library::shuffle(begin(range), end(range));
    return sort(std::forward<Range>(range), compare, projection);
  }
  template <random_access_iterator Iterator, class Compare = less>
  auto operator()(Iterator first, Iterator last, Compare compare = {}) const {
    other_library::shuffle(first, last);
    return sort(first, last, compare);
  }
};
inline constexpr OtherSort other_sort;

struct OtherPartialSort {
  template <class Range, class Compare = less, class Projection = identity>
  auto operator()(Range&& range, iterator_t<Range> middle, Compare compare = {},
                  Projection projection = {}) const {
    other_library::shuffle(begin(range), end(range));
    const auto last = partial_sort(range, middle, compare, projection);
    other_library::shuffle(middle, last);
    return last;
  }
};
inline constexpr OtherPartialSort other_partial_sort;

struct OtherNthElement {
  template <class Range, class Compare = less, class Projection = identity>
  auto operator()(Range&& range, iterator_t<Range> nth, Compare compare = {},
                  Projection projection = {}) const {
    other_library::shuffle(begin(range), end(range));
    const auto last = nth_element(range, nth, compare, projection);
    other_library::shuffle(begin(range), nth);
    if (nth != last) other_library::shuffle(nth + 1, last);
    return last;
  }
};
inline constexpr OtherNthElement other_nth_element;

}  // namespace ranges
}  // namespace std

// From here on the names mean these.
#define nth_element other_nth_element
#define partial_sort other_partial_sort
#define partition other_partition
#define pop_heap other_pop_heap
#define push_heap other_push_heap
#define sort other_sort

// std::priority_queue too.
#include <queue>

#endif
