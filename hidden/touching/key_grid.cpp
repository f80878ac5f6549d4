#include "hidden/touching/key_grid.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <map>

namespace displayfile {

namespace {

/// The exponent of the cubes' side: two to four tolerances, so that most searches examine one or
/// two cubes along each key.
int logarithm_for(double tolerance) {
  int exponent = 0;
  std::frexp(tolerance, &exponent);
  return exponent + 1;
}

}  // namespace

KeyGrid::KeyGrid(std::span<const double> tolerances) {
  constexpr double kLargest = 0.125;  // as a tolerance: larger cubes hardly distinguish items
  constexpr std::size_t kFew = 16;    // rarer sizes (below 1 / kFew) use larger cubes
  // Along a single key, cubes this small hold about one number each.
  const int finest = -2 - static_cast<int>(std::bit_width(tolerances.size()));
  std::map<int, std::size_t> searches;
  for (const double tolerance : tolerances) {
    if (tolerance <= kLargest) ++searches[std::max(finest, logarithm_for(tolerance))];
  }
  std::size_t waiting = 0;
  for (auto it = searches.begin(); it != searches.end(); ++it) {
    waiting += it->second;
    if (waiting * kFew < tolerances.size() && std::next(it) != searches.end()) continue;
    sizes_.push_back({std::ldexp(1.0, it->first), std::ldexp(1.0, -it->first), {}, {}});
    waiting = 0;
  }
  const std::size_t lists = std::bit_ceil(std::max<std::size_t>(tolerances.size(), 2));
  shift_ = 64 - std::countr_zero(lists);
  for (Size& size : sizes_) {
    size.first.assign(lists, kNone);
    size.next.assign(tolerances.size(), kNone);
  }
}

void KeyGrid::insert(std::uint32_t number, const Keys& keys) {
  for (Size& size : sizes_) {
    std::uint32_t& first =
        size.first[list_of({index(keys[0], size), index(keys[1], size), index(keys[2], size)})];
    assert(number < size.next.size());
    size.next[number] = first;
    first = number;
  }
}

}  // namespace displayfile
