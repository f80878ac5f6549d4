#pragma once

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace displayfile {

using Point2 = glm::dvec2;
using Point3 = glm::dvec3;
using HomogeneousPoint = glm::dvec4;

/// World coordinates larger than this (after the modelling transformation) are
/// refused, so that no product in the pipeline can overflow.
inline constexpr double kCoordinateLimit = 1e100;

/// True for a point that is finite and within kCoordinateLimit.
inline bool in_range(const Point3& p) {
  return std::abs(p.x) <= kCoordinateLimit && std::abs(p.y) <= kCoordinateLimit &&
         std::abs(p.z) <= kCoordinateLimit;  // false for NaN too
}

/// A vector of length 1 along v, which is not zero; unit(-v) = -unit(v). Scaled first, so that no
/// square overflows or vanishes.
inline Point3 unit(const Point3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const Point3 scaled = v / largest;
  return scaled / std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);
}

}  // namespace displayfile
