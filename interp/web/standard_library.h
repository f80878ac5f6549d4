#pragma once

#include <version>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <compare>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

// Replacements for parts of C++20's library that Debian's emscripten lacks: the algorithms of
// std::ranges in use, std::bit_cast, numbers as text. Each file of a build for WebAssembly includes
// it first; with a complete library it is empty.

// NOLINTBEGIN(cert-dcl58-cpp): these are the library's names, which it does not have
namespace std {

template <typename To, typename From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

template <typename Array>
auto make_unique_for_overwrite(size_t size) {
  return unique_ptr<Array>(new remove_extent_t<Array>[size]);
}

/// Allows default comparisons of classes with such a member.
template <typename Value>
constexpr auto operator<=>(const optional<Value>& a, const optional<Value>& b)
    -> decltype(*a <=> *b) {
  if (a && b) return *a <=> *b;
  return a.has_value() <=> b.has_value();
}

// ---- Numbers as text ----------------------------------------------------------------------------

/// The C library rounds correctly, but accepts more than from_chars does: blanks, plus signs,
/// hexadecimal digits. So it is only given input that from_chars would accept.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string_view text(first, static_cast<size_t>(last - first));
  const auto digits_end = [&](size_t k) {
    while (k < text.size() && text[k] >= '0' && text[k] <= '9') ++k;
    return k;
  };
  const auto is = [&](size_t k, string_view letters) {
    return k < text.size() && letters.find(text[k]) != string_view::npos;
  };
  const size_t start = is(0, "-") ? 1 : 0;
  size_t end = 0;
  if (is(start, "iInN")) {
    for (const string_view word : {"infinity", "inf", "nan"}) {
      size_t k = 0;
      while (k < word.size() && start + k < text.size() && (text[start + k] | 0x20) == word[k]) ++k;
      if (k == word.size()) {
        end = start + k;
        break;
      }
    }
  } else {
    const size_t whole = digits_end(start);
    size_t places = 0;
    end = whole;
    if (is(whole, ".")) {
      end = digits_end(whole + 1);
      places = end - whole - 1;
    }
    if (whole == start && places == 0) end = 0;
    if (end != 0 && is(end, "eE")) {
      const size_t exponent = end + (is(end + 1, "+-") ? 2 : 1);
      if (const size_t after = digits_end(exponent); after > exponent) end = after;
    }
  }
  if (end == 0) return {first, errc::invalid_argument};
  errno = 0;
  const double read = strtod(string(text.substr(0, end)).c_str(), nullptr);
  if (errno == ERANGE && (read == 0.0 || isinf(read))) {
    return {first + end, errc::result_out_of_range};
  }
  value = read;
  return {first + end, errc()};
}

/// The shortest text that reads back as the same number; of equally short ones that without an
/// exponent.
inline to_chars_result to_chars(char* first, char* last, double value) {
  char scientific[32], fixed[352];
  int digits = 0;
  do {
    snprintf(scientific, sizeof scientific, "%.*e", digits, value);
  } while (++digits < 17 && isfinite(value) && strtod(scientific, nullptr) != value);
  const char* shortest = scientific;
  if (const char* const e = strchr(scientific, 'e'); e != nullptr) {
    snprintf(fixed, sizeof fixed, "%.*f", max(0, digits - 1 - atoi(e + 1)), value);
    if (strlen(fixed) <= strlen(scientific)) shortest = fixed;
  }
  const size_t length = strlen(shortest);
  if (length > static_cast<size_t>(last - first)) return {last, errc::value_too_large};
  return {copy(shortest, shortest + length, first), errc()};
}

// ---- Algorithms over whole ranges ---------------------------------------------------------------

namespace ranges {

/// `compare` applied to the projections of two elements, `test` to that of one.
template <typename Compare, typename Projection>
constexpr auto compared(Compare& compare, Projection& projection) {
  return [&](auto&& a, auto&& b) -> bool {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}
template <typename Test, typename Projection>
constexpr auto tested(Test& test, Projection& projection) {
  return [&](auto&& a) -> bool { return std::invoke(test, std::invoke(projection, a)); };
}
template <typename Value, typename Projection>
constexpr auto equal_to_value(const Value& value, Projection& projection) {
  return [&](auto&& a) -> bool { return std::invoke(projection, a) == value; };
}

template <typename Range, typename Test, typename Projection = identity>
constexpr bool all_of(Range&& range, Test test, Projection projection = {}) {
  return std::all_of(std::begin(range), std::end(range), tested(test, projection));
}
template <typename Range, typename Test, typename Projection = identity>
constexpr bool any_of(Range&& range, Test test, Projection projection = {}) {
  return std::any_of(std::begin(range), std::end(range), tested(test, projection));
}
template <typename Range, typename Test, typename Projection = identity>
constexpr bool none_of(Range&& range, Test test, Projection projection = {}) {
  return std::none_of(std::begin(range), std::end(range), tested(test, projection));
}

template <typename Range, typename Work>
constexpr void for_each(Range&& range, Work work) {
  std::for_each(std::begin(range), std::end(range), std::ref(work));
}

template <typename Range, typename Test, typename Projection = identity>
constexpr auto find_if(Range&& range, Test test, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range), tested(test, projection));
}
template <typename Range, typename Test, typename Projection = identity>
constexpr auto find_if_not(Range&& range, Test test, Projection projection = {}) {
  return std::find_if_not(std::begin(range), std::end(range), tested(test, projection));
}
template <typename Range, typename Value, typename Projection = identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range), equal_to_value(value, projection));
}
template <typename Range, typename Same = equal_to, typename Projection = identity>
constexpr auto adjacent_find(Range&& range, Same same = {}, Projection projection = {}) {
  return std::adjacent_find(std::begin(range), std::end(range), compared(same, projection));
}

template <typename Range, typename Test, typename Projection = identity>
constexpr auto count_if(Range&& range, Test test, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range), tested(test, projection));
}
template <typename Range, typename Value, typename Projection = identity>
constexpr auto count(Range&& range, const Value& value, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range), equal_to_value(value, projection));
}

/// The length of the runs sorted by insertion before merging.
constexpr ptrdiff_t kInsertedRun = 16;

/// Inserts each element at its place among those before it.
template <typename Iterator, typename Less>
void sort_by_insertion(Iterator first, Iterator last, Less& less) {
  for (Iterator k = first; k != last; ++k) {
    auto element = std::move(*k);
    Iterator place = k;
    for (; place != first && less(element, *(place - 1)); --place) *place = std::move(*(place - 1));
    *place = std::move(element);
  }
}

/// Merges growing runs: O(n log n) comparisons for any elements, and stable. The library's sort is
/// five times as much code for each type of element, and there are many types.
template <typename Iterator, typename Less>
void sort_by_merging(Iterator first, Iterator last, Less& less) {
  const ptrdiff_t size = last - first;
  for (ptrdiff_t k = 0; k < size; k += kInsertedRun) {
    ranges::sort_by_insertion(first + k, first + std::min(size, k + kInsertedRun), less);
  }
  if (size <= kInsertedRun) return;
  vector<typename iterator_traits<Iterator>::value_type> room(make_move_iterator(first),
                                                              make_move_iterator(last));
  auto* from = room.data();
  auto* to = std::to_address(first);
  for (ptrdiff_t run = kInsertedRun; run < size; run *= 2) {
    for (ptrdiff_t k = 0; k < size; k += 2 * run) {
      const auto middle = make_move_iterator(from + std::min(size, k + run));
      std::merge(make_move_iterator(from + k), middle, middle,
                 make_move_iterator(from + std::min(size, k + 2 * run)), to + k, std::ref(less));
    }
    std::swap(from, to);
  }
  if (from == room.data()) std::move(from, from + size, first);
}

template <random_access_iterator Iterator, typename Less = less>
void sort(Iterator first, Iterator last, Less less = {}) {
  ranges::sort_by_merging(first, last, less);
}
template <random_access_iterator Iterator, typename Less = less>
void stable_sort(Iterator first, Iterator last, Less less = {}) {
  ranges::sort_by_merging(first, last, less);
}
template <typename Range, typename Less = less, typename Projection = identity>
auto sort(Range&& range, Less less = {}, Projection projection = {}) {
  auto order = compared(less, projection);
  ranges::sort_by_merging(std::begin(range), std::end(range), order);
  return std::end(range);
}
template <typename Range, typename Less = less, typename Projection = identity>
auto stable_sort(Range&& range, Less less = {}, Projection projection = {}) {
  return ranges::sort(range, less, projection);
}
template <typename Range, typename Iterator, typename Less = less, typename Projection = identity>
constexpr auto nth_element(Range&& range, Iterator nth, Less less = {},
                           Projection projection = {}) {
  std::nth_element(std::begin(range), nth, std::end(range), compared(less, projection));
  return std::end(range);
}
template <typename Range, typename Less = less, typename Projection = identity>
constexpr auto sort_heap(Range&& range, Less less = {}, Projection projection = {}) {
  std::sort_heap(std::begin(range), std::end(range), compared(less, projection));
  return std::end(range);
}
template <typename Range, typename Less = less, typename Projection = identity>
constexpr bool is_sorted(Range&& range, Less less = {}, Projection projection = {}) {
  return std::is_sorted(std::begin(range), std::end(range), compared(less, projection));
}
template <typename One, typename Other, typename Output, typename Less = less>
constexpr void merge(One&& one, Other&& other, Output output, Less less = {}) {
  std::merge(std::begin(one), std::end(one), std::begin(other), std::end(other), output,
             std::ref(less));
}

template <typename Range, typename Less = less, typename Projection = identity>
constexpr auto min_element(Range&& range, Less less = {}, Projection projection = {}) {
  return std::min_element(std::begin(range), std::end(range), compared(less, projection));
}
template <typename Range, typename Less = less, typename Projection = identity>
constexpr auto max_element(Range&& range, Less less = {}, Projection projection = {}) {
  return std::max_element(std::begin(range), std::end(range), compared(less, projection));
}
template <typename Value>
struct min_max_result {
  Value min, max;
};
template <typename Range, typename Less = less, typename Projection = identity>
constexpr auto minmax(Range&& range, Less less = {}, Projection projection = {}) {
  const auto [low, high] =
      std::minmax_element(std::begin(range), std::end(range), compared(less, projection));
  return min_max_result<std::remove_cvref_t<decltype(*low)>>{*low, *high};
}

template <typename Range, typename Value, typename Less = less, typename Projection = identity>
constexpr auto lower_bound(Range&& range, const Value& value, Less less = {},
                           Projection projection = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value,
                          [&](auto&& a, const Value& v) -> bool {
                            return std::invoke(less, std::invoke(projection, a), v);
                          });
}
template <typename Range, typename Value, typename Less = less, typename Projection = identity>
constexpr auto upper_bound(Range&& range, const Value& value, Less less = {},
                           Projection projection = {}) {
  return std::upper_bound(std::begin(range), std::end(range), value,
                          [&](const Value& v, auto&& a) -> bool {
                            return std::invoke(less, v, std::invoke(projection, a));
                          });
}
template <typename Range, typename Value, typename Less = less, typename Projection = identity>
constexpr bool binary_search(Range&& range, const Value& value, Less less = {},
                             Projection projection = {}) {
  const auto found = ranges::lower_bound(range, value, less, projection);
  return found != std::end(range) && !std::invoke(less, value, std::invoke(projection, *found));
}

template <typename Range, typename Value>
constexpr auto fill(Range&& range, const Value& value) {
  std::fill(std::begin(range), std::end(range), value);
  return std::end(range);
}
template <typename Range, typename Value>
constexpr void replace(Range&& range, const Value& old, const Value& by) {
  std::replace(std::begin(range), std::end(range), old, by);
}
template <typename Range>
constexpr auto reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
  return std::end(range);
}
template <typename Range, typename Output>
constexpr Output copy(Range&& range, Output output) {
  return std::copy(std::begin(range), std::end(range), output);
}
template <typename Range, typename Output, typename Test>
constexpr Output copy_if(Range&& range, Output output, Test test) {
  return std::copy_if(std::begin(range), std::end(range), output, std::ref(test));
}
template <typename Range, typename Output>
constexpr Output move(Range&& range, Output output) {
  return std::move(std::begin(range), std::end(range), output);
}
template <typename Range, typename Output, typename Work>
constexpr Output transform(Range&& range, Output output, Work work) {
  for (auto&& element : range) *output++ = std::invoke(work, element);
  return output;
}

template <typename One, typename Other, typename Same = equal_to>
constexpr bool equal(One&& one, Other&& other, Same same = {}) {
  return std::equal(std::begin(one), std::end(one), std::begin(other), std::end(other),
                    std::ref(same));
}
template <typename One, typename Other>
struct mismatch_result {
  One in1;
  Other in2;
};
template <typename One, typename Other>
constexpr auto mismatch(One&& one, Other&& other) {
  const auto [a, b] =
      std::mismatch(std::begin(one), std::end(one), std::begin(other), std::end(other));
  return mismatch_result<decltype(std::begin(one)), decltype(std::begin(other))>{a, b};
}

}  // namespace ranges
}  // namespace std
// NOLINTEND(cert-dcl58-cpp)

#endif
