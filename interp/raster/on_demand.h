#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace displayfile {

/// Lazily computed values, for several threads: a table that costs only what is used.
template <class T>
class OnDemand {
 public:
  /// Resizes and clears all values. Must not be called during use by others.
  void forget(std::size_t size) {
    if (size > values_.size()) {
      values_.resize(size);
      state_ = std::make_unique<std::atomic<std::uint8_t>[]>(size);
    }
    for (std::size_t i = 0; i < size; ++i) state_[i].store(kNone, std::memory_order_relaxed);
  }
  /// The value of that number: the result of make(), the same each time. While another thread
  /// computes it, a copy is made in `spare`.
  template <class Make>
  const T& at(std::size_t i, T& spare, Make&& make) {
    std::uint8_t state = state_[i].load(std::memory_order_acquire);
    if (state == kMade) return values_[i];
    if (state == kNone && state_[i].compare_exchange_strong(state, kMaking)) {
      values_[i] = make();
      state_[i].store(kMade, std::memory_order_release);
      return values_[i];
    }
    spare = make();
    return spare;
  }
  std::size_t bytes() const { return values_.size() * (sizeof(T) + sizeof(state_[0])); }

 private:
  enum : std::uint8_t { kNone, kMaking, kMade };
  std::vector<T> values_;
  std::unique_ptr<std::atomic<std::uint8_t>[]> state_;
};

}  // namespace displayfile
