#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace displayfile {

/// A subset of a scene's items whose data is stored in sequence; one bit per item.
class ItemRanks {
 public:
  /// Items must be added in ascending order.
  void add(std::uint32_t item) {
    while (words_.size() <= item / 64) words_.push_back({0, count_});
    assert(words_.size() == item / 64 + 1 && words_.back().bits >> item % 64 == 0);
    words_.back().bits |= std::uint64_t{1} << item % 64;
    ++count_;
  }
  /// The rank of an added item among those added, from 0.
  std::uint32_t operator[](std::uint32_t item) const {
    assert(item / 64 < words_.size() && (words_[item / 64].bits >> item % 64 & 1) != 0);
    const auto& [bits, before] = words_[item / 64];
    const std::uint64_t smaller = bits & ((std::uint64_t{1} << item % 64) - 1);
    return before + static_cast<std::uint32_t>(std::popcount(smaller));
  }
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t k = 0; k < words_.size(); ++k) {
      for (std::uint64_t left = words_[k].bits; left != 0; left &= left - 1) {
        visit(static_cast<std::uint32_t>(64 * k) +
              static_cast<std::uint32_t>(std::countr_zero(left)));
      }
    }
  }
  void clear() {
    words_.clear();
    count_ = 0;
  }
  std::size_t bytes() const { return words_.size() * sizeof(Word); }

 private:
  struct Word {
    std::uint64_t bits;
    std::uint32_t before;  ///< number of items in the words before
  };
  std::vector<Word> words_;
  std::uint32_t count_ = 0;
};

}  // namespace displayfile
