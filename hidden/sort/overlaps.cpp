#include "hidden/sort/overlaps.h"

#include <cassert>

namespace displayfile {

Overlaps::Overlaps(std::vector<Pair> pairs, std::size_t entries) : first_(entries + 1, 0) {
  for (const auto& [a, b] : pairs) {
    assert(a != b && a < entries && b < entries);
    ++first_[a + 1];
    ++first_[b + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  others_.resize(2 * pairs.size());
  assert(first_.back() == others_.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [a, b] : pairs) {
    others_[next[a]++] = b;
    others_[next[b]++] = a;
  }
  // Sorted, so that the order does not depend on that of the pairs.
  for (std::size_t i = 0; i < entries; ++i) {
    std::ranges::sort(others_.begin() + static_cast<std::ptrdiff_t>(first_[i]),
                      others_.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]));
  }
}

}  // namespace displayfile
