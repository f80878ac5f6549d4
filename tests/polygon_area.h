#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "clip/point.h"

namespace displayfile::test {

/// The area of the polygon's projection.
inline double area(std::span<const Point3> polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += a.x * b.y - b.x * a.y;
  }
  return std::abs(sum) / 2.0;
}

}  // namespace displayfile::test
