#pragma once

#include <span>
#include <vector>

#include "clip/bounds.h"
#include "clip/view.h"

namespace displayfile {

/// A scene that rotates about an axis in front of a fixed camera.
struct TurningPoints {
  std::span<const Point3> points;  ///< in world coordinates, before the first turn
  Point3 axis, middle;             ///< a unit vector, and a point that does not move
};

/// The points, in order, that may be outside of the bounds (x and y in view-plane coordinates) in
/// some rotation. All others are within them in any rotation, with any rounding.
std::vector<Point3> points_beyond(const TurningPoints& scene, const View& view, const Bounds& seen);

}  // namespace displayfile
