#pragma once

#include <cstdint>

#include "clip/point.h"

namespace displayfile {

/// A surface over a grid that was entered among a scene's polygons, as the perimeter method has to
/// know of it (hidden/lines/perimeter.md).
struct SurfaceMark {
  /// Where the surface's z grows toward, infinitely far: homogeneous device coordinates. W is 0 in
  /// a parallel view, and where the verticals of a perspective view are parallel.
  HomogeneousPoint upward;
  std::uint32_t x_points, y_points;  ///< two or more
};

}  // namespace displayfile
