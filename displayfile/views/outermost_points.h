#pragma once

#include <span>
#include <vector>

#include "clip/bounds.h"
#include "clip/view.h"

namespace displayfile {

/// A scene that turns about an axis before a camera that stays.
struct TurningPoints {
  std::span<const Point3> points;  ///< in world coordinates, before the first turn
  Point3 axis, middle;             ///< a unit vector, and a point that does not move
};

/// Those of its points that may be seen beyond the bounds (x and y in the view plane's coordinates)
/// in some turn, in order. All others are within them in any turn, however the way there is
/// rounded.
std::vector<Point3> points_beyond(const TurningPoints& scene, const View& view, const Bounds& seen);

}  // namespace displayfile
