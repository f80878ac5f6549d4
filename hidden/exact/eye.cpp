#include "hidden/exact/eye.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "clip/geometry/unit.h"
#include "hidden/exact/exact_vector.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

Eye Eye::of(const View& view) {
  if (view.projection == View::Projection::perspective) return Eye::at(view.centre_of_projection);
  const Point3& along = view.direction_of_projection;
  return Eye::toward(glm::dot(unit(along), unit(view.plane_normal)) < 0.0 ? along : -along);
}

/// An eye at infinity is a direction, whose component along the normal decides; the plane's filter
/// bounds this too, with one rounded difference fewer.
int side_of_plane(const Eye& eye, const Plane& plane) {
  assert(plane.is_plain());
  if (!eye.at_infinity) return side_of_plane(eye.place, plane);
  const Point3& v = eye.place;
  const double value = plane.normal.x * v.x + plane.normal.y * v.y + plane.normal.z * v.z;
  const double bound = plane.bound.x * std::abs(v.x) + plane.bound.y * std::abs(v.y) +
                       plane.bound.z * std::abs(v.z) + kTiny;
  if (std::abs(value) > bound) [[likely]]
    return decided_sign(value);
  count_exact(Predicate::side_of_plane);
  const ExactVector normal =
      cross(exact_difference(plane.q, plane.p), exact_difference(plane.r, plane.p));
  return dot(normal, exact_difference(v, Point3(0.0))).sign();
}

}  // namespace displayfile
