#pragma once

#include <glm/mat3x3.hpp>
#include <vector>

#include "clip/view.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile {

/// Turns what is drawn about the view-up axis, or another, through its middle, before a camera and
/// lights that stay: as the world is not to move (its tree is built once), the camera and the
/// lights go round it the other way.
class Turntable {
 public:
  struct Turn {
    View view;
    glm::dmat3 lights;  ///< a rotation
  };

  /// A turntable for the scene's visible segments, all drawn in one view; `attributes` says which
  /// are visible. Without any, `otherwise` is the view. Throws Error if they were drawn in several
  /// views.
  Turntable(const RetainedScene& scene, const DisplayFile& attributes, const View& otherwise);

  /// The scene turned by so many degrees, counterclockwise seen from above. At 0 the view is what
  /// it was, to the last bit.
  Turn at(double degrees) const;

  /// Turns about another axis than the view's up, of any length but zero.
  void set_axis(const Point3& world);

  /// Sets the window so that it shows the scene whole, with a small margin, in as many views
  /// evenly around; its aspect ratio stays.
  void fit_window(int views);

 private:
  View view_;
  Point3 axis_{0.0}, middle_{0.0};
  std::vector<Point3> points_;  // of all that is visible
};

}  // namespace displayfile
