#pragma once

#include <algorithm>
#include <cmath>

#include "clip/point.h"

namespace displayfile {

/// A vector of length 1 along v, which is not zero; unit(-v) = -unit(v). Scaled first, so that no
/// square overflows or vanishes.
inline Point3 unit(const Point3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const Point3 scaled = v / largest;
  return scaled / std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);
}

}  // namespace displayfile
