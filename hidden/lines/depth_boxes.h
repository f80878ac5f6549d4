#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hidden/boxes/box_tree.h"
#include "hidden/boxes/extents.h"

namespace displayfile {

/// An extent as a box of a tree that is also divided in depth.
struct DepthBox {
  Extent extent;

  static DepthBox nothing() { return {Extent::nothing()}; }
  void include(const DepthBox& o) { extent.include(o.extent); }

  /// Twice the middle along an axis, for a BoxTree; 0 for unbounded and empty ones.
  static constexpr std::size_t kAxes = 3;
  double position(std::size_t axis) const {
    const auto k = static_cast<int>(axis);
    const float sum = extent.low(k) + extent.high(k);
    return sum == sum ? double{sum} : 0.0;
  }
};

/// Eight of these boxes.
struct DepthBoxes {
  using Box = DepthBox;
  static constexpr std::size_t kBoxes = 8;

  std::array<float, kBoxes> x_min, x_max, y_min, y_max, z_min, z_max;

  void set(std::size_t k, const DepthBox& box) {
    const Extent& e = box.extent;
    x_min[k] = e.x_min;
    x_max[k] = e.x_max;
    y_min[k] = e.y_min;
    y_max[k] = e.y_max;
    z_min[k] = e.z_min;
    z_max[k] = e.z_max;
  }
  DepthBox box(std::size_t k) const {
    return {{x_min[k], x_max[k], y_min[k], y_max[k], z_min[k], z_max[k]}};
  }

  /// Tests all eight at once, without branches.
  std::array<std::int32_t, kBoxes> meets(const Extent& e) const {
    std::array<std::int32_t, kBoxes> met;
    for (std::size_t k = 0; k < kBoxes; ++k) {
      met[k] = static_cast<std::int32_t>(e.x_min <= x_max[k]) &
               static_cast<std::int32_t>(x_min[k] <= e.x_max) &
               static_cast<std::int32_t>(e.y_min <= y_max[k]) &
               static_cast<std::int32_t>(y_min[k] <= e.y_max) &
               static_cast<std::int32_t>(e.z_min <= z_max[k]) &
               static_cast<std::int32_t>(z_min[k] <= e.z_max);
    }
    return met;
  }
  std::array<std::int32_t, kBoxes> meets(const DepthBox& box) const { return meets(box.extent); }
};

/// Finds items near a place in space, and pairs that meet there, in device coordinates.
using DepthTree = BoxTree<DepthBoxes>;
template <>
void DepthTree::build(std::size_t items, const std::function<DepthBox(Item)>& box_of, int threads);

}  // namespace displayfile
