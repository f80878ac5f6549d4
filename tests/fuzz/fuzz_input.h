#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "clip/point.h"

namespace displayfile::fuzz {

/// Takes a fuzzer's bytes one after the other; zeros once they are used up.
class FuzzInput {
 public:
  explicit FuzzInput(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool empty() const { return bytes_.empty(); }
  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }
  /// From 0 to n - 1.
  int below(int n) { return byte() % n; }
  /// Any double at all, from its eight bytes.
  double any_double() {
    std::uint8_t raw[sizeof(double)];
    for (std::uint8_t& part : raw) part = byte();
    double value = 0.0;
    std::memcpy(&value, raw, sizeof value);
    return value;
  }
  /// On a grid of n steps from 0 to 1 and around it; from time to time an ulp or two aside.
  double near_grid(int n) {
    const std::uint8_t where = byte();
    double value = static_cast<double>(where % (2 * n) - n / 2) / n;
    if (where < 192) return value;
    constexpr double kFar = std::numeric_limits<double>::infinity();
    for (int ulps = below(4) - 2; ulps != 0; ulps += ulps < 0 ? 1 : -1) {
      value = std::nextafter(value, ulps < 0 ? -kFar : kFar);
    }
    return value;
  }
  Point3 point_near_grid(int n) {
    const double x = near_grid(n), y = near_grid(n), z = near_grid(n);
    return {x, y, z};
  }
  std::span<const std::uint8_t> rest() const { return bytes_; }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace displayfile::fuzz
