#pragma once

#include <glm/mat4x4.hpp>
#include <span>

#include "clip/view_volume.h"

namespace displayfile {

/// How far, in device coordinates along x and along y, the boundary of a piece that was cut in
/// world coordinates and then viewed may lie from the same boundary of the whole polygon, viewed
/// (hidden/sort/world_tree.md, "What rounding may move").
class ViewRounding {
 public:
  /// `volume` is the view's, and must stay.
  ViewRounding(const View& view, const ViewVolume& volume);

  /// The bound for a polygon or line and its pieces. `device` is what clipping left of it,
  /// `off_plane` how far a vertex lies from the plane that the tree takes the polygon to be in.
  double of(std::span<const Point3> world, std::span<const Point3> device, double off_plane) const;

 private:
  double size_of(const Point3& world) const;
  double per_w(double device_z) const;

  const glm::dmat4& matrix_;
  double size_of_step_;
  double per_w_at_0_ = 1.0, per_w_rise_ = 0.0;  // 1/W over device z
};

}  // namespace displayfile
