#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace displayfile {

/// A set of pixels of some rows of a picture, a bit each; it takes no memory until one is added.
/// Runs are columns first <= i < end of a row, within the picture and the set's rows.
class PixelSet {
 public:
  PixelSet(int width, int row_begin, int row_end)
      : width_(width), row_begin_(row_begin), row_end_(row_end) {}

  int row_begin() const { return row_begin_; }
  int row_end() const { return row_end_; }

  void add(int row, int first, int end) {
    if (words_.empty()) words_.assign(words_a_row() * static_cast<std::size_t>(rows()), 0);
    for_each_word(row, first, end, [&](std::size_t word, std::uint64_t run) {
      words_[word] |= run;
      return true;
    });
  }

  void remove(int row, int first, int end) {
    if (words_.empty()) return;
    for_each_word(row, first, end, [&](std::size_t word, std::uint64_t run) {
      words_[word] &= ~run;
      return true;
    });
  }

  bool contains(int row, int column) const { return any(row, column, column + 1); }

  bool any(int row, int first, int end) const {
    bool found = false;
    if (words_.empty()) return found;
    for_each_word(row, first, end, [&](std::size_t word, std::uint64_t run) {
      found = (words_[word] & run) != 0;
      return !found;
    });
    return found;
  }

  bool empty() const {
    return std::ranges::all_of(words_, [](std::uint64_t word) { return word == 0; });
  }

  std::size_t size() const {
    std::size_t n = 0;
    for (const std::uint64_t word : words_) n += static_cast<std::size_t>(std::popcount(word));
    return n;
  }

  /// Calls visit(row, column), row by row from the bottom, left to right.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const int row = row_begin_ + static_cast<int>(i / words_a_row());
      const int column = static_cast<int>(i % words_a_row()) * kBits;
      for (std::uint64_t rest = words_[i]; rest != 0; rest &= rest - 1) {
        visit(row, column + std::countr_zero(rest));
      }
    }
  }

 private:
  static constexpr int kBits = 64;

  int rows() const { return row_end_ - row_begin_; }
  std::size_t words_a_row() const { return static_cast<std::size_t>((width_ + kBits - 1) / kBits); }

  /// Calls visit(index, bits of the run) for each word of the run while it returns true.
  template <class Visit>
  void for_each_word(int row, int first, int end, Visit&& visit) const {
    constexpr std::uint64_t kAll = ~std::uint64_t{0};
    if (first >= end) return;
    const std::size_t start = static_cast<std::size_t>(row - row_begin_) * words_a_row();
    const int last_word = (end - 1) / kBits;
    for (int w = first / kBits; w <= last_word; ++w) {
      const int from = std::max(first - w * kBits, 0), to = std::min(end - w * kBits, kBits);
      const std::uint64_t run = (kAll << from) & (kAll >> (kBits - to));
      if (!visit(start + static_cast<std::size_t>(w), run)) return;
    }
  }

  int width_, row_begin_, row_end_;
  std::vector<std::uint64_t> words_;
};

}  // namespace displayfile
