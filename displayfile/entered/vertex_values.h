#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
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

/// Vertex values of some of a scene's items, intensities or normals: one per vertex, in order of
/// entry.
template <class Value>
class VertexValues {
 public:
  /// Values added from now on are spans of `stored`, which must outlive this; they are not copied.
  void lie_in(std::span<const Value> stored) { all_ = stored; }
  /// Adds an item's values; items must be added in ascending order.
  void add(std::uint32_t item, std::span<const Value> values) {
    assert(first_.size() <= item);
    first_.resize(item, kNone);
    if (all_.empty()) {
      first_.push_back(static_cast<std::uint32_t>(own_.size()));
      own_.insert(own_.end(), values.begin(), values.end());
    } else {
      assert(all_.data() <= values.data() &&
             values.data() + values.size() <= all_.data() + all_.size());
      first_.push_back(static_cast<std::uint32_t>(values.data() - all_.data()));
    }
  }
  /// Appends the values of another scene's items, which begin at first_item. Neither refers to
  /// outside storage.
  void append(const VertexValues& part, std::uint32_t first_item) {
    if (part.first_.empty()) return;
    assert(all_.empty() && first_.size() <= first_item);
    first_.resize(first_item, kNone);
    const auto before = static_cast<std::uint32_t>(own_.size());
    for (const std::uint32_t first : part.first_) {
      first_.push_back(first == kNone ? kNone : first + before);
    }
    own_.insert(own_.end(), part.own_.begin(), part.own_.end());
  }
  void clear() {
    all_ = {};
    own_.clear();
    first_.clear();
  }

  bool empty() const { return first_.empty(); }  ///< no item has any
  /// The values of an item with this many sides; empty if it has none.
  std::span<const Value> of(std::uint32_t item, std::uint32_t sides) const {
    if (item >= first_.size() || first_[item] == kNone) return {};
    return (all_.empty() ? std::span<const Value>(own_) : all_).subspan(first_[item], sides);
  }
  std::size_t bytes() const {  ///< of its own arrays, as used
    return own_.size() * sizeof(Value) + first_.size() * sizeof(first_[0]);
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::span<const Value> all_;  // empty: these are own_
  std::vector<Value> own_;
  std::vector<std::uint32_t> first_;  // of items up to the last that has some, or kNone
};

}  // namespace displayfile
