#pragma once

#include <glm/mat4x4.hpp>

#include "clip/bounds.h"
#include "clip/view.h"

namespace displayfile {

/// From the device coordinates of a view back to the world, and how far rounding on the way there
/// and back may move what lies in a box: shadows that are found in the world are those that are
/// found in the view if that is less than what is allowed for (interp/raster/shadows.md).
class WayToWorld {
 public:
  /// The box is that of the scene. Throws Error as ViewVolume does.
  WayToWorld(const View& view, const Bounds& box);

  Point3 operator()(const Point3& device) const {
    const HomogeneousPoint p = to_world_[0] * device.x + to_world_[1] * device.y +
                               (to_world_[2] * device.z + to_world_[3]);
    return Point3(p) / p.w;
  }

  /// How far apart, in the world, a vertex and a ray that meet in the view may be, at most, if no
  /// depth in the view is larger, |z|; infinite if nothing can be said.
  double error(double largest_depth) const;
  /// A device coordinate that is off by e moves the point in the world by no more than this times
  /// e, for small e.
  double stretch() const { return stretch_; }

 private:
  glm::dmat4 to_device_, to_world_;  // homogeneous
  double stretch_, steepest_, of_vertices_;
};

}  // namespace displayfile
