#include "hidden/exact/orientation.h"

#include "hidden/exact/estimates.h"
#include "hidden/exact/exact_vector.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

ExactNumber difference(double a, double b) { return ExactNumber(a) - ExactNumber(b); }

}  // namespace

int exact_orientation(const Point2& a, const Point2& b, const Point2& c) {
  // Each product has a zero factor, as on an axis-parallel line.
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

}  // namespace displayfile
