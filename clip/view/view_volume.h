#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>

#include "clip/point.h"
#include "clip/view.h"

namespace displayfile {

/// The bounds of the view volume, in the order in which the pipeline clips against them.
enum class ClipPlane { back, front, eye, left, right, bottom, top };
inline constexpr int kClipPlanes = 7;

/// A set of clip planes, one bit each.
using Outcode = unsigned;
constexpr Outcode bit_of(ClipPlane plane) { return 1u << static_cast<unsigned>(plane); }

/// The view, computed once when a segment opens.
///
/// One matrix takes world coordinates to a homogeneous point (X, Y, Z, W) for which the
/// view volume is the unit cube 0 <= X, Y, Z <= W: X from the window's left to its right,
/// Z from the back plane (0) to the front plane (1). For a perspective view that matrix is
/// the perspective-to-parallel transform (problem book, 10.2 and 10.3): after division by
/// W, planes are still planes, the depth order is kept, and projectors are parallel to z.
/// For a parallel view W is always 1.
class ViewVolume {
 public:
  /// Throws Error if view up lies along the normal, the centre of projection is on the wrong
  /// side of the view plane or the front plane, or the direction of projection is parallel to
  /// the view plane.
  explicit ViewVolume(const View& view);

  HomogeneousPoint transform(const Point3& world) const {
    const auto& m = world_to_volume_;
    return {m[0] * world.x + m[1] * world.y + (m[2] * world.z + m[3])};
  }

  /// The planes outside of which the point lies; if a coordinate is NaN, every bit that may apply.
  Outcode outcode(const HomogeneousPoint& p) const {
    Outcode code = 0;
    code |= p.z >= 0.0 ? 0u : bit_of(ClipPlane::back);
    code |= p.z <= p.w ? 0u : bit_of(ClipPlane::front);
    code |= p.w >= nearest_w_ ? 0u : bit_of(ClipPlane::eye);
    code |= p.x >= 0.0 ? 0u : bit_of(ClipPlane::left);
    code |= p.x <= p.w ? 0u : bit_of(ClipPlane::right);
    code |= p.y >= 0.0 ? 0u : bit_of(ClipPlane::bottom);
    code |= p.y <= p.w ? 0u : bit_of(ClipPlane::top);
    return code & active_;
  }

  /// Distance inside of a plane, in the plane's own units: 0 on it, negative outside. For a finite
  /// point and an active plane it is negative exactly where outcode has the plane's bit.
  double inside_distance(ClipPlane plane, const HomogeneousPoint& p) const;

  /// Moves a point that is on the plane except for rounding exactly onto it: inside_distance
  /// becomes 0.
  void snap(ClipPlane plane, HomogeneousPoint& p) const;

  /// Normalised device coordinates of a point inside the volume. A point on a side of the
  /// window comes out on that side of the viewport, exactly.
  Point3 to_device(const HomogeneousPoint& p) const {
    const Point3 cube = perspective_ ? Point3(p.x / p.w, p.y / p.w, p.z / p.w) : Point3(p);
    return {between(viewport_.x_min, viewport_.x_max, cube.x),
            between(viewport_.y_min, viewport_.y_max, cube.y), cube.z};
  }

  /// The point at infinity in a world direction, which is not zero: homogeneous normalised device
  /// coordinates, scaled so that the largest is 1 or -1. W is 0 in a parallel view.
  HomogeneousPoint infinitely_far(const Point3& direction) const;

  const View& view() const { return view_; }
  /// World coordinates to view-plane coordinates: the origin is the view reference point
  /// moved by the view distance along the normal; z grows toward the viewer.
  const glm::dmat4& view_plane() const { return view_plane_; }
  /// World coordinates to the homogeneous unit cube.
  const glm::dmat4& matrix() const { return world_to_volume_; }
  const Rectangle& viewport() const { return viewport_; }
  /// True if world coordinates are device coordinates: viewing does not round.
  bool is_identity() const {
    return world_to_volume_ == glm::dmat4(1.0) && viewport_ == Rectangle{0.0, 1.0, 0.0, 1.0};
  }
  bool is_perspective() const { return perspective_; }
  /// z of the front and back planes, in view-plane coordinates.
  double front_z() const { return front_z_; }
  double back_z() const { return back_z_; }
  /// Points with smaller W are outside of ClipPlane::eye; above 0 in a perspective view.
  double nearest_w() const { return nearest_w_; }
  /// The planes that points can be outside of.
  Outcode active() const { return active_; }

 private:
  static double between(double low, double high, double t) {
    return low == 0.0 && high == 1.0 ? t : (1.0 - t) * low + t * high;
  }

  View view_;
  glm::dmat4 view_plane_;
  glm::dmat4 world_to_volume_;
  Rectangle viewport_;
  bool perspective_;
  double nearest_w_;
  double front_z_, back_z_;
  Outcode active_;
};

/// Transforms many points as ClipPipeline::view does one, bit for bit, with the processor's widest
/// vectors of doubles. `device` gets device coordinates, 0 for points outside of a clip plane,
/// `outcodes` their outcodes; both have the length of `world`.
void view_points(const ViewVolume& volume, std::span<const Point3> world, std::span<Point3> device,
                 std::span<std::uint8_t> outcodes);

}  // namespace displayfile
