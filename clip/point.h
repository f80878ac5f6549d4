#pragma once

/// Points, vectors and rectangles, in doubles.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

namespace displayfile {

using Point2 = glm::dvec2;
using Point3 = glm::dvec3;
using HomogeneousPoint = glm::dvec4;

/// Limit of world coordinates (after the modelling transformation). Larger ones are refused, so
/// that no product in the pipeline can overflow.
inline constexpr double kCoordinateLimit = 1e100;

/// True for a point that is finite and within kCoordinateLimit.
inline bool in_range(const Point3& p) {
  const auto is_within = [](double c) { return -kCoordinateLimit <= c && c <= kCoordinateLimit; };
  return is_within(p.x) && is_within(p.y) && is_within(p.z);  // false for NaN too
}

/// A rectangle: a window in the view plane, a viewport in normalised device coordinates, or a
/// bounding rectangle in the projection. (clip/geometry/bounds.h has boxes in space.)
struct Rectangle {
  double x_min, x_max, y_min, y_max;
  bool operator==(const Rectangle&) const = default;

  /// The empty rectangle, with its limits reversed.
  static constexpr Rectangle nothing() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {kInfinity, -kInfinity, kInfinity, -kInfinity};
  }
  bool is_nothing() const { return x_min > x_max; }
  void include(const Point2& p) {
    if (p.x < x_min) x_min = p.x;
    if (p.x > x_max) x_max = p.x;
    if (p.y < y_min) y_min = p.y;
    if (p.y > y_max) y_max = p.y;
  }
};

}  // namespace displayfile
