#pragma once

#include <algorithm>
#include <cmath>

#include "clip/point.h"

namespace displayfile {

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
