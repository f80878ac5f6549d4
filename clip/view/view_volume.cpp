#include "clip/view/view_volume.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "clip/base/error.h"
#include "clip/geometry/unit.h"

namespace displayfile {

namespace {

/// With front clipping off, a perspective view is clipped where W, the distance in front of
/// the centre of projection over that of the view plane, falls to this.
constexpr double kNearestToEye = 1e-6;

/// With front clipping on, a perspective view is clipped where W falls to this fraction of W at the
/// front plane: nothing is left there, unless coordinates are so large that W is lost in their
/// rounding.
constexpr double kPartOfFront = 0.5;

/// Two directions closer than this (the sine of the angle between them) count as parallel.
constexpr double kParallelDirections = 1e-12;

/// MAKE-VIEW-PLANE-TRANSFORMATION: rows are the view plane's axes, z toward the viewer.
glm::dmat4 view_plane_transformation(const View& view) {
  const Point3 into_scene = unit(view.plane_normal);
  const Point3 z = -into_scene;
  const Point3 across = glm::cross(unit(view.up), z);
  if (glm::dot(across, across) < kParallelDirections * kParallelDirections) {
    throw Error("view up along the view plane normal: expected another direction for view up");
  }
  const Point3 x = unit(across);
  const Point3 y = glm::cross(z, x);
  const Point3 origin = view.reference_point + view.distance * into_scene;
  glm::dmat4 m(1.0);  // m[column][row]
  for (int i = 0; i < 3; ++i) {
    m[i][0] = x[i];
    m[i][1] = y[i];
    m[i][2] = z[i];
  }
  m[3] = HomogeneousPoint(-glm::dot(x, origin), -glm::dot(y, origin), -glm::dot(z, origin), 1.0);
  for (int row = 0; row < 3; ++row) m[3][row] += 0.0;  // no minus zero in the identity
  return m;
}

/// How projectors run, in view-plane coordinates: a point at depth z meets the view plane
/// at (x - shear.x z, y - shear.y z) / (1 - convergence z). Parallel projectors do not
/// converge; those of a perspective view meet where z is 1 / convergence.
struct Projectors {
  Point2 shear;
  double convergence;
};

Projectors projectors(const View& view, const glm::dmat4& view_plane) {
  if (view.projection == View::Projection::perspective) {
    const Point3 centre(view_plane * HomogeneousPoint(view.centre_of_projection, 1.0));
    if (!(centre.z > 0.0)) {
      throw Error(
          "centre of projection on the wrong side: expected it on the viewer's side of the view "
          "plane");
    }
    return {Point2(centre) / centre.z, 1.0 / centre.z};
  }
  const Point3 d(view_plane * HomogeneousPoint(unit(view.direction_of_projection), 0.0));
  if (std::abs(d.z) < kParallelDirections) {
    throw Error("direction of projection parallel to the view plane");
  }
  return {Point2(d) / d.z, 0.0};
}

}  // namespace

ViewVolume::ViewVolume(const View& view)
    : view_(view),
      view_plane_(view_plane_transformation(view)),
      viewport_(view.viewport),
      perspective_(view.projection == View::Projection::perspective),
      front_z_(view.distance - view.front),
      back_z_(view.distance - view.back) {
  const auto [shear, convergence] = projectors(view, view_plane_);
  const double w_front = 1.0 - convergence * front_z_;
  if (!(w_front > 0.0)) {
    throw Error(
        "centre of projection on the wrong side of the front plane: expected the front plane "
        "(set-view-depth) in front of it");
  }
  const Point2 width(view.window.x_max - view.window.x_min, view.window.y_max - view.window.y_min);
  const Point2 corner(view.window.x_min, view.window.y_min);
  const double depth_scale = w_front / (front_z_ - back_z_);

  glm::dmat4 cube(0.0);  // view-plane coordinates to the homogeneous unit cube
  for (int axis = 0; axis < 2; ++axis) {
    cube[axis][axis] = 1.0 / width[axis];
    cube[2][axis] = (corner[axis] * convergence - shear[axis]) / width[axis];
    cube[3][axis] = -corner[axis] / width[axis];
  }
  cube[2][2] = depth_scale;
  cube[3][2] = -depth_scale * back_z_;
  cube[2][3] = -convergence;
  cube[3][3] = 1.0;
  world_to_volume_ = cube * view_plane_;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!(std::abs(world_to_volume_[column][row]) <= kCoordinateLimit)) {
        throw Error("view out of range: window, view depth or centre of projection too extreme");
      }
    }
  }

  active_ = bit_of(ClipPlane::left) | bit_of(ClipPlane::right) | bit_of(ClipPlane::bottom) |
            bit_of(ClipPlane::top);
  if (view.back_clipping) active_ |= bit_of(ClipPlane::back);
  if (view.front_clipping) active_ |= bit_of(ClipPlane::front);
  if (perspective_) active_ |= bit_of(ClipPlane::eye);
  nearest_w_ = view.front_clipping ? kPartOfFront * w_front : kNearestToEye;
  assert(nearest_w_ > 0.0);
}

HomogeneousPoint ViewVolume::infinitely_far(const Point3& direction) const {
  const auto& m = world_to_volume_;
  HomogeneousPoint p = m[0] * direction.x + m[1] * direction.y + m[2] * direction.z;
  p.x = viewport_.x_min * p.w + (viewport_.x_max - viewport_.x_min) * p.x;
  p.y = viewport_.y_min * p.w + (viewport_.y_max - viewport_.y_min) * p.y;
  const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(p.w)});
  return largest > 0.0 ? p / largest : p;
}

double ViewVolume::inside_distance(ClipPlane plane, const HomogeneousPoint& p) const {
  switch (plane) {
    case ClipPlane::back: return p.z;
    case ClipPlane::front: return p.w - p.z;
    case ClipPlane::eye: return p.w - nearest_w_;
    case ClipPlane::left: return p.x;
    case ClipPlane::right: return p.w - p.x;
    case ClipPlane::bottom: return p.y;
    case ClipPlane::top: return p.w - p.y;
  }
  return 0.0;
}

void ViewVolume::snap(ClipPlane plane, HomogeneousPoint& p) const {
  switch (plane) {
    case ClipPlane::back: p.z = 0.0; break;
    case ClipPlane::front: p.z = p.w; break;
    case ClipPlane::eye: p.w = nearest_w_; break;
    case ClipPlane::left: p.x = 0.0; break;
    case ClipPlane::right: p.x = p.w; break;
    case ClipPlane::bottom: p.y = 0.0; break;
    case ClipPlane::top: p.y = p.w; break;
  }
  assert(inside_distance(plane, p) == 0.0);
}

}  // namespace displayfile
