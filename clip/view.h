#pragma once

#include <string_view>

#include "clip/point.h"

namespace displayfile {

/// The view parameters of the textbook's chapter 8. Each set_ routine checks its own arguments and
/// throws Error, leaving the view unchanged; ViewVolume checks them together when a segment opens.
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
  /// Parallel projection along a world direction; oblique if it differs from the normal's.
  void set_parallel(const Point3& world_direction);
  /// Perspective projection from a centre of projection in world coordinates.
  void set_perspective(const Point3& world_centre);
  /// Front and back planes, as distances from the view reference point along the normal.
  void set_depth(double front, double back);
  void set_window(const Rectangle& view_plane);
  /// The viewport must lie within [0,1] x [0,1].
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

/// A perspective view from an eye toward a target, in world coordinates. `up` is a world direction
/// that appears upright. The view plane passes through the target, which is in the middle of the
/// picture. The window is a square that covers the vertical angle of view, in degrees;
/// displayfile::fit makes one that shows a whole scene. The front plane is 0.999 of the eye's
/// distance in front of the target, the back plane that distance behind it; neither clips.
/// View::set_parallel(target - eye) makes it a parallel view. Errors: a coordinate that is not
/// finite or exceeds kCoordinateLimit; the eye is at the target; `up` is zero or along the line of
/// sight; an angle that is not above 0 and below 180.
View look_at(const Point3& eye, const Point3& target, const Point3& up = {0.0, 1.0, 0.0},
             double angle_of_view = 45.0);

/// How a window is mapped to a viewport with another aspect ratio in the picture.
enum class WindowFit {
  widen,    ///< the window is widened or heightened about its middle, without distortion
  stretch,  ///< the window is mapped to the viewport as it is
};

/// Reads `widen` or `stretch`; throws Error for anything else.
WindowFit window_fit(std::string_view text);
std::string_view name_of(WindowFit fit);

}  // namespace displayfile
