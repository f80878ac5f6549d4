#pragma once

#include "clip/point.h"
#include "clip/rectangle.h"

namespace displayfile {

/// The view parameters of the textbook's chapter 8. Each set_ routine checks what it can
/// check alone and throws Error, leaving the view as it was; what depends on several
/// parameters together is checked by ViewVolume, when a segment opens.
class View {
 public:
  enum class Projection { parallel, perspective };

  void set_reference_point(const Point3& world);
  /// Points away from the viewer, into the scene; any length but zero.
  void set_plane_normal(const Point3& world);
  /// The distance from the view reference point to the view plane, along the normal.
  void set_distance(double distance);
  /// A world direction that appears upright; any length but zero.
  void set_up(const Point3& world);
  /// Parallel projection along a world direction; oblique if that is not the normal's.
  void set_parallel(const Point3& world_direction);
  /// Perspective projection from a centre of projection in world coordinates.
  void set_perspective(const Point3& world_centre);
  /// Front and back planes, as distances from the view reference point along the normal.
  void set_depth(double front, double back);
  void set_window(const Rectangle& view_plane);
  /// The viewport lies within [0,1] x [0,1].
  void set_viewport(const Rectangle& device);

  Point3 reference_point{0.0, 0.0, 0.0};
  Point3 plane_normal{0.0, 0.0, -1.0};
  double distance = 0.0;
  Point3 up{0.0, 1.0, 0.0};
  Projection projection = Projection::parallel;
  Point3 direction_of_projection{0.0, 0.0, 1.0};
  Point3 centre_of_projection{0.0, 0.0, 5.0};
  double front = -1.0, back = 3.0;
  bool front_clipping = false, back_clipping = false;
  Rectangle window{-1.0, 1.0, -1.0, 1.0};
  Rectangle viewport{0.0, 1.0, 0.0, 1.0};

  bool operator==(const View&) const = default;
};

}  // namespace displayfile
