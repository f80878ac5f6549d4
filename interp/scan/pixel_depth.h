#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "hidden/exact/plane.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

/// A polygon's depth over pixel coordinates: the slides' plane equation, z changing by -A/C per
/// column and -B/C per row. A pixel's depth is always the same expression of its centre, row(j)
/// first and at(row, i) after it, wherever one begins: every caller gets the same double.
struct PixelDepth {
  double x0 = 0.0, y0 = 0.0, z0 = 0.0, dz_dx = 0.0, dz_dy = 0.0;

  PixelDepth() = default;
  /// The depth of a polygon in normalised device coordinates, not edge-on, on a picture of width x
  /// height.
  PixelDepth(std::span<const Point3> device, const SupportVertices& support, double width,
             double height)
      : PixelDepth(
            Plane(device[support.index[0]], device[support.index[1]], device[support.index[2]]),
            width, height) {}
  /// The depth of a plane in normalised device coordinates.
  PixelDepth(const Plane& plane, double width, double height)
      : x0(plane.p.x * width), y0(plane.p.y * height), z0(plane.p.z) {
    const double per_c = -1.0 / plane.normal.z;
    dz_dx = plane.normal.x * per_c / width;
    dz_dy = plane.normal.y * per_c / height;
  }

  double row(int j) const { return z0 + dz_dy * (j + 0.5 - y0); }
  double at(double row_depth, int i) const { return row_depth + dz_dx * (i + 0.5 - x0); }
  /// The depth at any point.
  double at_point(double x, double y) const { return z0 + dz_dy * (y - y0) + dz_dx * (x - x0); }

  /// Bounds the error of at() for the plane from which this was made, at centres at most dx and dy
  /// pixels from (x0, y0). Infinite if unknown. Derived in interp/visibility/close_depths.md.
  double error(const Plane& plane, double width, double height, double dx, double dy) const {
    const double c = std::abs(plane.normal.z) - plane.bound.z;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (!(c > 0.0)) return kInfinity;
    const double slope_x = std::abs(dz_dx), slope_y = std::abs(dz_dy);
    const double error = ((plane.bound.x / width + slope_x * plane.bound.z) * dx +
                          (plane.bound.y / height + slope_y * plane.bound.z) * dy) /
                         c;
    const double rounding = slope_x * (std::abs(x0) + 6.0 * dx) +
                            slope_y * (std::abs(y0) + 6.0 * dy) + 2.0 * std::abs(z0);
    const double bound = 2.0 * (error + kUnit * rounding) + kTiny;
    return bound < kInfinity ? bound : kInfinity;  // also where it is not a number
  }
};

}  // namespace displayfile
