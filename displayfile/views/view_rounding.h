#pragma once

#include <glm/mat4x4.hpp>
#include <span>

#include "clip/view/view_volume.h"

namespace displayfile {

/// Bounds the distance, in device coordinates along x and y, between the boundary of a piece that
/// was cut in world coordinates and then viewed, and that of the whole polygon, viewed
/// (hidden/sort/world_tree.md, "What rounding may move").
class ViewRounding {
 public:
  /// `volume` is the view's, and must outlive it.
  ViewRounding(const View& view, const ViewVolume& volume);

  /// The bound for a polygon or line and its pieces. `device` is its clipped part, `off_plane` the
  /// largest distance of a vertex from the plane that the tree uses for the polygon.
  double of(std::span<const Point3> world, std::span<const Point3> device, double off_plane) const;

 private:
  double size_of(const Point3& world) const;
  double per_w(double device_z) const;

  const glm::dmat4& matrix_;
  double size_of_step_;
  double per_w_at_0_ = 1.0, per_w_rise_ = 0.0;  // 1/W over device z
};

}  // namespace displayfile
