#pragma once

#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "clip/geometry/bounds.h"
#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile {

/// Rotates a scene about the view-up axis, or another, through its middle, in front of a fixed
/// camera and fixed lights: since the world must not move (its tree is built once), the camera and
/// the lights are rotated the other way.
class Turntable {
 public:
  struct Turn {
    View view;
    glm::dmat3 lights;  ///< a rotation
  };

  /// A turntable for the scene's visible segments, all drawn in one view; `attributes` has their
  /// visibility. Without any, `otherwise` is the view. Throws Error if they were drawn in several
  /// views.
  Turntable(const RetainedScene& scene, const DisplayFile& attributes, const View& otherwise);

  /// The scene rotated by this angle in degrees, counterclockwise seen from above. At 0 the view is
  /// unchanged, bit for bit.
  Turn at(double degrees) const;

  /// Sets the axis, of any non-zero length; the default is the view's up.
  void set_axis(const Point3& world);

  /// Sets the window to show the whole scene, with a small margin, in this many views at equal
  /// angles; its aspect ratio is unchanged.
  void fit_window(int views);

 private:
  View view_;
  Point3 axis_{0.0}, middle_{0.0};
  std::vector<Point3> points_;  // of all that is visible
};

/// A scene that rotates about an axis in front of a fixed camera.
struct TurningPoints {
  std::span<const Point3> points;  ///< in world coordinates, before the first turn
  Point3 axis, middle;             ///< a unit vector, and a point that does not move
};

/// The points, in order, that may be outside of the bounds (x and y in view-plane coordinates) in
/// some rotation. All others are within them in any rotation, with any rounding.
std::vector<Point3> points_beyond(const TurningPoints& scene, const View& view, const Bounds& seen);

}  // namespace displayfile
