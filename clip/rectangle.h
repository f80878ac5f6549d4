#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "clip/point.h"

namespace displayfile {

/// A rectangle, in doubles: of the view plane (window), of normalised device coordinates
/// (viewport), or around a polygon in the projection. (clip/bounds.h has boxes in space.)
struct Rectangle {
  double x_min, x_max, y_min, y_max;
  bool operator==(const Rectangle&) const = default;

  /// The rectangle around no point: turned inside out.
  static constexpr Rectangle nothing() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {kInfinity, -kInfinity, kInfinity, -kInfinity};
  }
  bool is_nothing() const { return x_min > x_max; }
  void include(const Point2& p) {
    x_min = std::min(x_min, p.x);
    x_max = std::max(x_max, p.x);
    y_min = std::min(y_min, p.y);
    y_max = std::max(y_max, p.y);
  }
};

/// The rectangle around one point or more in the projection, for the minimax test; exact.
/// (hidden/extents.h has boxes in space, rounded outward.)
inline Rectangle bounding_rectangle(std::span<const Point3> vertices) {
  Rectangle r = Rectangle::nothing();
  for (const Point3& v : vertices) r.include(Point2(v));
  return r;
}

}  // namespace displayfile
