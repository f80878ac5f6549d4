#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace displayfile {

/// Finds numbered items with three nearly equal keys each: a grid of cubes in a hash table, with a
/// few sizes. A search examines the cubes within its tolerance: one or two along each key.
class KeyGrid {
 public:
  /// Each 0 or more, and not much above 4.
  using Keys = std::array<double, 3>;

  /// For numbers below the size of `tolerances`, which are those of the searches, each above 2^-50.
  explicit KeyGrid(std::span<const double> tolerances);

  /// False if the tolerance is too large for cubes.
  bool has_size_for(double tolerance) const {
    return !sizes_.empty() && tolerance <= sizes_.back().length;
  }
  void insert(std::uint32_t number, const Keys& keys);

  /// Calls visit(number) for all inserted numbers with every key within the tolerance, and for
  /// others, possibly repeatedly, until it returns false. Requires a size for the tolerance.
  template <class Visit>
  void visit_near(const Keys& keys, double tolerance, Visit&& visit) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  using Cube = std::array<std::uint64_t, 3>;
  struct Size {
    double length, per_length;         ///< of a cube's side, a power of two, and 1 over it
    std::vector<std::uint32_t> first;  ///< number in a list of the table
    std::vector<std::uint32_t> next;   ///< number after a number
  };
  static std::uint64_t index(double key, const Size& size) {
    return static_cast<std::uint64_t>(key * size.per_length);
  }
  std::size_t list_of(const Cube& cube) const {
    const std::uint64_t mixed = cube[0] * 0x9e3779b97f4a7c15u + cube[1] * 0xc2b2ae3d27d4eb4fu +
                                cube[2] * 0x165667b19e3779f9u;
    return static_cast<std::size_t>(((mixed ^ mixed >> 32) * 0x9e3779b97f4a7c15u) >> shift_);
  }

  std::vector<Size> sizes_;  // rising
  int shift_ = 63;
};

template <class Visit>
void KeyGrid::visit_near(const Keys& keys, double tolerance, Visit&& visit) const {
  assert(has_size_for(tolerance));
  const double wide = tolerance * (1.0 + 0x1p-40) + 0x1p-50;  // for the roundings of sums
  std::size_t of = 0;
  while (tolerance > sizes_[of].length) ++of;
  const Size& size = sizes_[of];
  Cube low{}, high{};
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = index(keys[k] > wide ? keys[k] - wide : 0.0, size);
    high[k] = index(keys[k] + wide, size);
  }
  Cube cube{};
  for (cube[0] = low[0]; cube[0] <= high[0]; ++cube[0]) {
    for (cube[1] = low[1]; cube[1] <= high[1]; ++cube[1]) {
      for (cube[2] = low[2]; cube[2] <= high[2]; ++cube[2]) {
        for (std::uint32_t i = size.first[list_of(cube)]; i != kNone; i = size.next[i]) {
          if (!visit(i)) return;
        }
      }
    }
  }
}

}  // namespace displayfile
