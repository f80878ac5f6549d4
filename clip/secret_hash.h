#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "clip/point.h"

namespace displayfile {

/// Hashes for tables whose keys come from files: with numbers that are drawn anew in each process,
/// so that nobody can write a file whose keys all fall into one place, which makes a table's time
/// grow with the square of their number. Never anything that a result depends on.
class SecretHash {
 public:
  SecretHash() noexcept;
  /// Takes the same numbers in each process, from the first hash on: for who counts instructions.
  static void use_known_numbers() noexcept;

  std::size_t operator()(std::uint64_t key) const noexcept { return last(mixed(secret_, key)); }
  /// Equal points have equal hashes, whichever zero they are written with.
  std::size_t operator()(const Point3& p) const noexcept { return last(of(p)); }
  std::size_t operator()(const Point3& p, std::uint64_t key) const noexcept {
    return last(mixed(of(p), key));
  }

 private:
  std::uint64_t of(const Point3& p) const noexcept {
    std::uint64_t h = secret_;
    for (int axis = 0; axis < 3; ++axis) h = mixed(h, std::bit_cast<std::uint64_t>(p[axis] + 0.0));
    return h;
  }
  std::uint64_t mixed(std::uint64_t h, std::uint64_t more) const noexcept {
    h = (h ^ more) * odd_;
    return h ^ (h >> 32);
  }
  /// The highest bits of a key have reached only some of the lowest, which tables use.
  static std::size_t last(std::uint64_t h) noexcept {
    h *= 0x9E3779B97F4A7C15u;  // 2^64 over the golden ratio
    return static_cast<std::size_t>(h ^ (h >> 29));
  }

  std::uint64_t secret_, odd_;
};

}  // namespace displayfile
