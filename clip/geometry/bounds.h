#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "clip/point.h"

namespace displayfile {

/// The closed bounding box of points in space, in doubles; any coordinates. Without points, low is
/// above high.
struct Bounds {
  Point3 low{std::numeric_limits<double>::infinity()};
  Point3 high{-std::numeric_limits<double>::infinity()};

  static Bounds nothing() { return {}; }
  /// The box never shrinks, and is the same in whatever order points are included.
  void include(const Point3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void include(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool empty() const { return !(low.x <= high.x); }
  Point3 middle() const { return low + 0.5 * (high - low); }

  /// Twice the middle along an axis, for a BoxTree.
  static constexpr std::size_t kAxes = 3;
  double position(std::size_t axis) const {
    const auto k = static_cast<int>(axis);
    return low[k] + high[k];
  }
};

inline double largest_coordinate(const Point3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// The largest of points in any container; 0 if there are none.
template <class Points>
double largest_coordinate(const Points& points) {
  double largest = 0.0;
  for (const Point3& p : points) largest = std::max(largest, largest_coordinate(p));
  return largest;
}

}  // namespace displayfile
