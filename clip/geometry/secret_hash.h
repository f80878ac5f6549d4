#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "clip/point.h"

namespace displayfile {

/// Hashes for tables whose keys come from files, seeded randomly in each process, so that no file
/// can be made whose keys all collide, which would take quadratic time. No result may depend on
/// them.
class SecretHash {
 public:
  SecretHash() noexcept;
  /// Uses fixed seeds, before the first hash; for counting instructions.
  static void use_known_numbers() noexcept;

  std::size_t operator()(std::uint64_t key) const noexcept { return last(mixed(secret_, key)); }
  /// Equal points have equal hashes, for 0 and -0 too.
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
