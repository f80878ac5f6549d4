#pragma once

#include <glm/common.hpp>
#include <limits>

#include "clip/point.h"

namespace displayfile {

/// The box around points, in doubles; any coordinates. Without points low is above high.
struct Bounds {
  Point3 low{std::numeric_limits<double>::infinity()};
  Point3 high{-std::numeric_limits<double>::infinity()};

  void include(const Point3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool empty() const { return !(low.x <= high.x); }
  Point3 middle() const { return low + 0.5 * (high - low); }
};

}  // namespace displayfile
