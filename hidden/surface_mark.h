#pragma once

#include <cstdint>

#include "clip/point.h"

namespace displayfile {

/// A surface over a grid among a scene's polygons, for the perimeter method
/// (hidden/lines/perimeter.md).
struct SurfaceMark {
  /// The point at infinity in the surface's direction of growing z: homogeneous device coordinates.
  /// W is 0 in a parallel view, and where the verticals of a perspective view are parallel.
  HomogeneousPoint upward;
  std::uint32_t x_points, y_points;  ///< two or more
};

}  // namespace displayfile
