#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace displayfile {

/// Values in the order in which they came, few of them more than once: one that comes again finds
/// its number unless another of its kind of hash came in between. So a few values stay a few, and
/// as many as there are faces cost no search.
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
  std::vector<std::uint32_t> slots_;  // the number that was given last, by the hash's last bits
};

}  // namespace displayfile
