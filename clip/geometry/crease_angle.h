#pragma once

#include "clip/point.h"

namespace displayfile {

/// The angle between two directions of any length, 0 to pi, within 8 units in the last place;
/// 0 if one has none. It is a function of its arguments alone, which the C library's arctangents
/// are not: these differ from one library to the next. angle_between(a, b) = angle_between(b, a).
double angle_between(const Point3& a, const Point3& b);

/// The range of angles of creases [degrees]; NaN is outside.
constexpr bool is_crease_angle(double degrees) { return degrees >= 0.0 && degrees <= 180.0; }
/// The angle that no two polygons exceed [degrees].
inline constexpr double kNoCrease = 180.0;
/// Throws Error for degrees out of that range.
void require_crease_angle(double degrees);

/// Decides whether two polygons that share a side meet there in a crease, for lines
/// (displayfile/segments/line_kinds.md) and for smooth shading (displayfile/looks/gouraud.md).
/// Polygons are coplanar at 0 degrees and folded onto each other at 180. The angle is that between
/// their normals (Newell's), oriented as if they ran through the side in opposite directions.
class CreaseAngle {
 public:
  /// Polygons that meet at less [radians] are coplanar whatever the angle: where a flat polygon was
  /// cut into triangles, or stored in single precision (clip/geometry/planarity.h).
  static constexpr double kCoplanar = 1e-5;

  /// The least angle of a crease, exclusive. Requires is_crease_angle(degrees).
  explicit CreaseAngle(double degrees);

  /// True if the polygons with these normals of length 1 meet at more. A polygon that runs down the
  /// side, not up, has its normal reversed: so normals of coplanar polygons are opposite.
  bool exceeded(const Point3& a, const Point3& b) const;
  /// The same for the angle between two such normals [radians].
  bool exceeded(double between) const;

 private:
  double least_;   // radians
  double cosine_;  // of that angle
};

}  // namespace displayfile
