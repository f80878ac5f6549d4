#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace displayfile {

/// Indexed values in order of first occurrence, with few duplicates: a repeated value finds its
/// index unless another with the same hash slot came in between. So few values stay few, and many
/// cost no search.
template <class Value>
class Palette {
 public:
  std::uint32_t number(const Value& value, std::uint64_t hash) {
    if (slots_.empty()) slots_.resize(kSlots, 0);
    std::uint32_t& slot = slots_[hash % kSlots];
    if (slot < values_.size() && values_[slot] == value) return slot;
    slot = static_cast<std::uint32_t>(values_.size());
    values_.push_back(value);
    return slot;
  }

  const std::vector<Value>& values() const { return values_; }
  std::vector<Value>&& take() && { return std::move(values_); }

 private:
  static constexpr std::size_t kSlots = 4096;

  std::vector<Value> values_;
  std::vector<std::uint32_t> slots_;  // last index by the hash's low bits
};

}  // namespace displayfile
