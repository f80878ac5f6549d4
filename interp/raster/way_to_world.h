#pragma once

#include <glm/mat4x4.hpp>

#include "clip/geometry/bounds.h"
#include "clip/view.h"

namespace displayfile {

/// Maps the device coordinates of a view back to the world, and bounds the displacement by rounding
/// there and back for points in a box: shadows found in the world are those of the view if that is
/// below the allowed value (interp/raster/shadows.md).
class WayToWorld {
 public:
  /// `box` bounds the scene. Throws Error as ViewVolume does.
  WayToWorld(const View& view, const Bounds& box);

  Point3 operator()(const Point3& device) const {
    const HomogeneousPoint p = to_world_[0] * device.x + to_world_[1] * device.y +
                               (to_world_[2] * device.z + to_world_[3]);
    return Point3(p) / p.w;
  }

  /// Bound on the distance, in the world, of a vertex and a ray that meet in the view, if no depth
  /// in the view is larger, |z|; infinite if unknown.
  double error(double largest_depth) const;
  /// A device coordinate that is off by e moves the point in the world by no more than this times
  /// e, for small e.
  double stretch() const { return stretch_; }

 private:
  glm::dmat4 to_device_, to_world_;  // homogeneous
  double stretch_, steepest_, of_vertices_;
};

}  // namespace displayfile
