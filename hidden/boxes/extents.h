#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "clip/point.h"
#include "hidden/boxes/box_tree.h"

namespace displayfile {

/// The largest float that is no more than v.
float rounded_down(double v);

/// The box around a polygon, for the minimax (boxing) test; floats rounded outward, so that
/// boxes that are apart enclose polygons that are apart.
struct Extent {
  float x_min, x_max, y_min, y_max, z_min, z_max;

  /// The empty extent; it meets only unbounded ones.
  static Extent nothing();
  /// Contains all points between these.
  static Extent between(const Point3& low, const Point3& high);
  /// Includes a box of this radius around the point.
  void include(const Point3& p, double radius = 0.0);
  void include(const Extent& other);

  float low(int axis) const { return axis == 0 ? x_min : axis == 1 ? y_min : z_min; }
  float high(int axis) const { return axis == 0 ? x_max : axis == 1 ? y_max : z_max; }
  bool meets_in_projection(const Extent& o) const {
    return x_min <= o.x_max && o.x_min <= x_max && y_min <= o.y_max && o.y_min <= y_max;
  }
};

/// An extent's rectangle in the projection.
struct FlatBox {
  float x_min, x_max, y_min, y_max;

  static FlatBox nothing();
  static FlatBox of(const Extent& e) { return {e.x_min, e.x_max, e.y_min, e.y_max}; }
  void include(const FlatBox& o) {
    x_min = std::min(x_min, o.x_min);
    x_max = std::max(x_max, o.x_max);
    y_min = std::min(y_min, o.y_min);
    y_max = std::max(y_max, o.y_max);
  }

  /// Twice the middle along an axis, for a BoxTree; 0 for unbounded and empty ones.
  static constexpr std::size_t kAxes = 2;
  double position(std::size_t axis) const {
    const float sum = axis == 0 ? x_min + x_max : y_min + y_max;
    return sum == sum ? double{sum} : 0.0;
  }
};

/// Eight of these boxes.
struct FlatBoxes {
  using Box = FlatBox;
  static constexpr std::size_t kBoxes = 8;

  std::array<float, kBoxes> x_min, x_max, y_min, y_max;

  void set(std::size_t k, const FlatBox& b) {
    x_min[k] = b.x_min;
    x_max[k] = b.x_max;
    y_min[k] = b.y_min;
    y_max[k] = b.y_max;
  }
  FlatBox box(std::size_t k) const { return {x_min[k], x_max[k], y_min[k], y_max[k]}; }

  /// Tests all eight at once, without branches.
  std::array<std::int32_t, kBoxes> meets(const FlatBox& b) const {
    std::array<std::int32_t, kBoxes> met;
    for (std::size_t k = 0; k < kBoxes; ++k) {
      met[k] = static_cast<std::int32_t>(b.x_min <= x_max[k]) &
               static_cast<std::int32_t>(x_min[k] <= b.x_max) &
               static_cast<std::int32_t>(b.y_min <= y_max[k]) &
               static_cast<std::int32_t>(y_min[k] <= b.y_max);
    }
    return met;
  }
};

/// Finds all pairs of extents that meet in the projection without comparing all: n log n to build,
/// then the cost of the pairs and of the paths to them. Divided in halves.
using ExtentTree = BoxTree<FlatBoxes>;
template <>
void ExtentTree::build(std::size_t items, const std::function<FlatBox(Item)>& box_of, int threads);

ExtentTree extent_tree(std::span<const Extent> extents, int threads);

}  // namespace displayfile
