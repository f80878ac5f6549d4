#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace displayfile {

/// A set of numbers below a limit, in order: a bit for each number, and above every 64 words a word
/// that tells which of them are not zero. A step costs one word a level, four levels for 2^24.
class NumberSet {
 public:
  static constexpr std::size_t kNone = ~std::size_t{0};

  explicit NumberSet(std::size_t limit) {
    do {
      limit = (limit + 63) / 64;
      levels_.emplace_back(limit);
    } while (limit > 1);
  }

  void insert(std::size_t number) {
    for (std::vector<std::uint64_t>& level : levels_) {
      level[number / 64] |= std::uint64_t{1} << number % 64;
      number /= 64;
    }
  }

  bool contains(std::size_t number) const {
    return (levels_[0][number / 64] >> number % 64 & 1) != 0;
  }

  /// The least member greater than the number, or kNone.
  std::size_t after(std::size_t number) const {
    for (std::size_t k = 0; k < levels_.size(); ++k, number /= 64) {
      const std::size_t bit = number % 64;
      const std::uint64_t higher = bit == 63 ? 0 : ~std::uint64_t{0} << (bit + 1);
      const std::uint64_t found = levels_[k][number / 64] & higher;
      if (found == 0) continue;
      number = number / 64 * 64 + static_cast<std::size_t>(std::countr_zero(found));
      while (k > 0) number = number * 64 + lowest(levels_[--k][number]);
      return number;
    }
    return kNone;
  }

  /// The greatest member less than the number, or kNone.
  std::size_t before(std::size_t number) const {
    for (std::size_t k = 0; k < levels_.size(); ++k, number /= 64) {
      const std::uint64_t lower = (std::uint64_t{1} << number % 64) - 1;
      const std::uint64_t found = levels_[k][number / 64] & lower;
      if (found == 0) continue;
      number = number / 64 * 64 + highest(found);
      while (k > 0) number = number * 64 + highest(levels_[--k][number]);
      return number;
    }
    return kNone;
  }

 private:
  static std::size_t lowest(std::uint64_t word) {
    return static_cast<std::size_t>(std::countr_zero(word));
  }
  static std::size_t highest(std::uint64_t word) {
    return 63 - static_cast<std::size_t>(std::countl_zero(word));
  }

  std::vector<std::vector<std::uint64_t>> levels_;  // the numbers' own first
};

}  // namespace displayfile
