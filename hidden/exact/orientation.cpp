#include "hidden/exact/orientation.h"

#include <cassert>

#include "hidden/exact/estimates.h"
#include "hidden/exact/exact_vector.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

ExactNumber difference(double a, double b) { return ExactNumber(a) - ExactNumber(b); }

}  // namespace

int exact_orientation(const Point2& a, const Point2& b, const Point2& c) {
  // Both products have a factor that is zero, as on a line along an axis.
  if ((a.x == c.x || b.y == c.y) && (a.y == c.y || b.x == c.x)) {
    count_by_definition(Predicate::orientation_2);
    return 0;
  }
  if (is_double_double_sound()) {
    const DoubleDouble dx = exact_difference(a.x, c.x), dy = exact_difference(a.y, c.y);
    if (const int sign = decided_sign(estimated_turn(c, dx, dy, b)); sign != 0) return sign;
  }
  count_exact(Predicate::orientation_2);
  return (difference(a.x, c.x) * difference(b.y, c.y) - difference(a.y, c.y) * difference(b.x, c.x))
      .sign();
}

int exact_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (is_double_double_sound()) {
    if (const int sign = decided_sign(estimated_value({a, b, c}, d)); sign != 0) return sign;
  }
  count_exact(Predicate::orientation_3);
  return dot(cross(exact_difference(b, a), exact_difference(c, a)), exact_difference(d, a)).sign();
}

int exact_facing(std::span<const Point3> vertices) {
  assert(!vertices.empty());
  count_exact(Predicate::facing);
  ExactNumber twice_area;
  const Point3* p = &vertices.back();
  for (const Point3& q : vertices) {
    twice_area =
        twice_area + ExactNumber(p->x) * ExactNumber(q.y) - ExactNumber(q.x) * ExactNumber(p->y);
    p = &q;
  }
  return twice_area.sign();
}

int facing(std::span<const Point3> vertices) {
  if (vertices.size() < 3) return 0;
  const Point3 origin = vertices.front();
  double sum = 0.0, products = 0.0;
  double px = 0.0, py = 0.0;  // the first vertex, seen from itself
  for (const Point3& vertex : vertices.subspan(1)) {
    const double qx = vertex.x - origin.x, qy = vertex.y - origin.y;
    const double left = px * qy, right = py * qx;
    sum += left - right;
    products += std::abs(left) + std::abs(right);
    px = qx;
    py = qy;
  }
  const auto sides = static_cast<double>(vertices.size());
  const double per_side = (sides + 4.0) * kUnit * kInflate;
  const double own = 1.0 + (sides + 4.0) * 4.0 * kUnit;  // the bound's own sum
  if (std::abs(sum) > per_side * products * own + sides * kTiny) {
    return decided_sign(sum);
  }
  return exact_facing(vertices);
}

}  // namespace displayfile
