#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace displayfile {

/// Planes in single precision, in a row: a point is compared with as many at once as a vector has
/// floats. Any coordinate system.
class PlanesInRow {
 public:
  /// Indices from begin up to end, excluded.
  struct Run {
    std::uint32_t begin, end;
  };
  struct Plane {
    std::array<float, 3> normal;
    float distance;  ///< of the plane from the origin, along the normal
  };

  /// A point that is no farther from a plane than `near` is near it.
  PlanesInRow(std::size_t planes, float near);

  void put(std::size_t at, const Plane& plane, std::uint32_t number) {
    planes_[at] = plane;
    numbers_[at] = number;
  }
  const Plane& operator[](std::size_t at) const { return planes_[at]; }
  std::uint32_t number(std::size_t at) const { return numbers_[at]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(numbers_.size()); }

  /// Prefetches the planes from the index on that are compared first.
  void read_ahead(std::size_t at) const {
    __builtin_prefetch(&planes_[at]);
    __builtin_prefetch(&planes_[at + kAtOnce / 2]);
  }
  void read_number_ahead(std::size_t at) const { __builtin_prefetch(&numbers_[at]); }
  /// The indices of those that the point is near, by float arithmetic: all in the runs, now and
  /// then others, or one twice. Valid until the next call.
  std::span<const std::uint32_t> near(const std::array<float, 3>& point, std::span<const Run> runs);

 private:
  static constexpr std::size_t kAtOnce = 8;
  using Form = std::size_t(const Plane*, float, const std::array<float, 3>&, std::span<const Run>,
                           std::uint32_t*);
  static Form* widest_form();

  std::vector<Plane> planes_;  // and kAtOnce at a distance of NaN: no point is near
  std::vector<std::uint32_t> numbers_, found_;
  float near_;
  Form* find_;
};

}  // namespace displayfile
