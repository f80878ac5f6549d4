#pragma once

#include <algorithm>
#include <span>

#include "clip/geometry/corners.h"
#include "clip/point.h"

namespace displayfile {

/// The intensity over the picture of a polygon cut from one triangle: linear, as the depth of its
/// plane. Device coordinates.
struct IntensityPlane {
  double x0 = 0.0, y0 = 0.0, i0 = 0.0;  ///< a vertex and its intensity
  double di_dx = 0.0, di_dy = 0.0;
  double low = 0.0, high = 0.0;  ///< range over the vertices, to which results are clamped

  IntensityPlane() = default;
  /// The plane through the vertices with the largest span (hidden/exact/support_plane.h). The mean
  /// everywhere if the polygon is edge-on, or too nearly so for a slope in doubles.
  IntensityPlane(std::span<const Point3> device, std::span<const double> intensities);

  double within(double intensity) const {
    return intensity > low ? std::min(intensity, high) : low;  // low for NaN too
  }
  double at(const Point3& p) const { return within(i0 + di_dy * (p.y - y0) + di_dx * (p.x - x0)); }
};

/// The normal over the picture of a polygon cut from one triangle, not of length 1: each component
/// is linear, as an intensity is (displayfile/entered/normal_plane.h). Device coordinates.
struct NormalPlane {
  double x0 = 0.0, y0 = 0.0;  ///< a vertex
  Point3 n0{0.0};             ///< and its normal
  Point3 dn_dx{0.0}, dn_dy{0.0};
  Point3 low{0.0}, high{0.0};  ///< range of the vertices' components, to which results are clamped

  NormalPlane() = default;
  /// The plane through the vertices with the largest span (hidden/exact/support_plane.h). The mean
  /// everywhere if the polygon is edge-on, or too nearly so for a slope in doubles.
  NormalPlane(std::span<const Point3> device, std::span<const Point3> normals);

  static Point3 within(const Point3& normal, const Point3& low, const Point3& high);
  Point3 at(const Point3& p) const {
    return within(n0 + dn_dy * (p.y - y0) + dn_dx * (p.x - x0), low, high);
  }
};

}  // namespace displayfile
