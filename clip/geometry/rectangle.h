#pragma once

#include <span>

#include "clip/point.h"

namespace displayfile {

/// The rectangle around one point or more in the projection, for the minimax test; exact.
/// (hidden/boxes/extents.h has boxes in space, rounded outward.)
inline Rectangle bounding_rectangle(std::span<const Point3> vertices) {
  Rectangle r = Rectangle::nothing();
  for (const Point3& v : vertices) r.include(Point2(v));
  return r;
}

/// A rectangle in a plane, given by two corners: the extent of letters, or of a view on paper.
struct PaperBox {
  Point2 low, high;

  PaperBox widened(const Point2& by) const { return {low - by, high + by}; }
  /// True if the interiors overlap.
  bool overlaps(const PaperBox& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y &&
           other.low.y < high.y;
  }
  bool lies_in(const PaperBox& other) const {
    return low.x >= other.low.x && low.y >= other.low.y && high.x <= other.high.x &&
           high.y <= other.high.y;
  }
};

}  // namespace displayfile
