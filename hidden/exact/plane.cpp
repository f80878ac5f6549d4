#include "hidden/exact/plane.h"

#include <cassert>

#include "hidden/exact/estimates.h"
#include "hidden/exact/exact_point.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

/// a d - b c, where each argument is a rounded difference; and for the filters the sum of its error
/// bound and four units of its magnitude (predicates.md, section 4).
struct NormalComponent {
  double value, bound;
};
NormalComponent normal_component(double a, double d, double b, double c) {
  const double left = a * d, right = b * c;
  const double value = left - right;
  const double error = 4.0 * kUnit * (std::abs(left) + std::abs(right)) + kTiny;
  return {value, (error + 4.0 * kUnit * std::abs(value)) * kInflate + kTiny};
}

/// True if the point and the plane's points have one coordinate along an axis in common: the point
/// is on the plane, or the plane's points are collinear.
bool is_across_an_axis(const Plane& plane, const Point3& v) {
  const auto are_level = [&](int axis) {
    return v[axis] == plane.p[axis] && v[axis] == plane.q[axis] && v[axis] == plane.r[axis];
  };
  return plane.is_plain() && (are_level(0) || are_level(1) || are_level(2));
}

}  // namespace

Plane::Plane(const Point3& p_, const Point3& q_, const Point3& r_, const Point3& rest_)
    : p(p_), q(q_), r(r_), rest(rest_) {
  const double ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
  const double vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  const NormalComponent a = normal_component(uy, vz, uz, vy);
  const NormalComponent b = normal_component(uz, vx, ux, vz);
  const NormalComponent c = normal_component(ux, vy, uy, vx);
  normal = {a.value, b.value, c.value};
  bound = {a.bound, b.bound, c.bound};
  if (!is_plain()) [[unlikely]] {  // uz and vz lack rests
    const double u = std::abs(rest.x) + std::abs(rest.y), v = std::abs(rest.x) + std::abs(rest.z);
    bound.x += (std::abs(uy) * v + std::abs(vy) * u) * (2.0 * kInflate);
    bound.y += (std::abs(ux) * v + std::abs(vx) * u) * (2.0 * kInflate);
    off = (std::abs(c.value) + c.bound) * std::abs(rest.x) * kInflate + kTiny;
  }
  reach =
      (std::abs(a.value) + std::abs(b.value) + std::abs(c.value) + bound.x + bound.y + bound.z) *
      kInflate;
  assert(bound.x >= kTiny && bound.y >= kTiny && bound.z >= kTiny && off >= kTiny);
}

int facing_axis(const Plane& plane) {
  const auto size = [&](int i) { return std::abs(plane.normal[i]); };
  const int most = size(0) > size(1) ? (size(0) > size(2) ? 0 : 2) : (size(1) > size(2) ? 1 : 2);
  if (size(most) > plane.bound[most]) [[likely]]
    return most;
  const ExactVector normal = ExactPlane(plane).normal;
  if (normal.z.sign() != 0) return 2;
  assert(normal.y.sign() != 0 || normal.x.sign() != 0);
  return normal.y.sign() != 0 ? 1 : 0;
}

int exact_side_of_plane(const Point3& v, const Plane& plane) {
  if (plane.goes_through(v) || is_across_an_axis(plane, v)) {
    count_by_definition(Predicate::side_of_plane);
    return 0;
  }
  if (is_double_double_sound()) {
    if (const int sign = decided_sign(estimated_value(plane, v)); sign != 0) return sign;
  }
  count_exact(Predicate::side_of_plane);
  return value_at(ExactPlane(plane), exact_point(v)).sign();
}

}  // namespace displayfile
