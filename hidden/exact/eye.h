#pragma once

#include "clip/point.h"
#include "clip/view.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/plane.h"

namespace displayfile {

/// The viewpoint of a scene, in world coordinates.
struct Eye {
  /// The centre of a perspective projection.
  static Eye at(const Point3& centre) { return {centre, false}; }
  /// A parallel projection: any vector toward the viewer, not zero.
  static Eye toward(const Point3& direction) { return {direction, true}; }
  static Eye of(const View& view);

  Point3 place;
  bool at_infinity;
  bool operator==(const Eye&) const = default;
};

/// The side of the plane on which the eye is: 1, -1, or 0 on it. True for coordinates up to
/// kCoordinateLimit. The sign flips if two of the plane's points are exchanged, and for an eye at
/// infinity if the direction is reversed. The plane has no rests.
int side_of_plane(const Eye& eye, const Plane& plane);
/// The side of the plane through three points.
inline int side_of_plane(const Eye& eye, const Point3& p, const Point3& q, const Point3& r) {
  return eye.at_infinity ? side_of_plane(eye, {p, q, r}) : orientation(p, q, r, eye.place);
}

}  // namespace displayfile
