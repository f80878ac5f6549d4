#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "clip/geometry/secret_hash.h"
#include "clip/point.h"

namespace displayfile {

/// Finds points that are equal bit for bit, by a hash table that is at most half full.
class EqualPoints {
 public:
  /// Appends at most `most` points to `points`, which must outlive it.
  EqualPoints(std::vector<Point3>& points, std::size_t most)
      : points_(points), table_(std::bit_ceil(2 * most + 1), kFree) {}

  /// Forgets all points so far: only points added later are found.
  void forget() { first_ = points_.size(); }
  /// The point's index; it is added if not found.
  std::uint32_t number_of(const Point3& p) {
    std::size_t at = hash_(p) & (table_.size() - 1);
    while (table_[at] != kFree && !is(table_[at], p)) at = (at + 1) & (table_.size() - 1);
    if (table_[at] == kFree) {
      table_[at] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(p);
    }
    return table_[at];
  }

 private:
  static constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
  using Bits = std::array<std::uint64_t, 3>;

  bool is(std::uint32_t number, const Point3& p) const {
    return number >= first_ && std::bit_cast<Bits>(points_[number]) == std::bit_cast<Bits>(p);
  }

  SecretHash hash_;
  std::vector<Point3>& points_;
  std::vector<std::uint32_t> table_;
  std::size_t first_ = 0;
};

}  // namespace displayfile
