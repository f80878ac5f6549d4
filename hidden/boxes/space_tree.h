#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "clip/geometry/bounds.h"
#include "hidden/boxes/box_tree.h"

namespace displayfile {

/// Eight boxes in space.
struct SpaceBoxes {
  using Box = Bounds;
  static constexpr std::size_t kBoxes = 8;

  std::array<std::array<double, kBoxes>, 3> low, high;  ///< by axis

  void set(std::size_t k, const Bounds& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis][k] = box.low[static_cast<int>(axis)];
      high[axis][k] = box.high[static_cast<int>(axis)];
    }
  }
};

/// A tree of boxes in space, for rays of any direction and all views; finite coordinates. Divided
/// in halves, so that no input makes a deep tree.
using SpaceTree = BoxTree<SpaceBoxes>;
template <>
void SpaceTree::build(std::size_t items, const std::function<Bounds(Item)>& box_of, int threads);

/// An infinite ray from a point; the direction is not zero.
class SpaceRay {
 public:
  SpaceRay(const Point3& from, const Point3& direction) : from_(from) {
    constexpr double kLeast = 1e-300;  // in place of less: no quotient is 0/0
    for (int k = 0; k < 3; ++k) {
      const double d = direction[k];
      per_direction_[k] = 1.0 / (std::abs(d) < kLeast ? std::copysign(kLeast, d) : d);
    }
  }
  /// The boxes whose interior the ray meets, possibly with some that it misses by a few roundings.
  /// (Callers that need the faces enlarge the boxes, as Shadows does.)
  SpaceTree::Lanes operator()(const SpaceBoxes& boxes) const {
    constexpr double kFarther = 1.0 + 0x1p-48;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::array<double, SpaceBoxes::kBoxes> enters{}, leaves;
    leaves.fill(kInfinity);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from = from_[static_cast<int>(axis)];
      const double per_direction = per_direction_[static_cast<int>(axis)];
      // The face met first, by the direction.
      const auto& near = per_direction < 0.0 ? boxes.high[axis] : boxes.low[axis];
      const auto& far = per_direction < 0.0 ? boxes.low[axis] : boxes.high[axis];
      for (std::size_t k = 0; k < SpaceBoxes::kBoxes; ++k) {
        const double a = (near[k] - from) * per_direction, b = (far[k] - from) * per_direction;
        enters[k] = a > enters[k] ? a : enters[k];
        leaves[k] = b < leaves[k] ? b : leaves[k];
      }
    }
    SpaceTree::Lanes met;
    for (std::size_t k = 0; k < SpaceBoxes::kBoxes; ++k) {
      met[k] = enters[k] <= leaves[k] * kFarther ? 1 : 0;
    }
    return met;
  }

 private:
  Point3 from_, per_direction_;
};

}  // namespace displayfile
