#include "hidden/exact/depth_order.h"

#include "hidden/exact/estimates.h"
#include "hidden/exact/exact_point.h"
#include "hidden/exact/plane_in_picture.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

/// w A (x - p.x) + w B (y - p.y) - w C p.z at the projector (x / w, y / w): the plane's z
/// there is this, negated, over w C.
ExactNumber exact_value(const ExactPlane& plane, const ExactNumber& x, const ExactNumber& y,
                        const ExactNumber& w) {
  return plane.normal.x * (x - plane.through.x * w) + plane.normal.y * (y - plane.through.y * w) -
         plane.normal.z * plane.through.z * w;
}

int exact_order(const Plane& a, const Plane& b, const ExactNumber& x, const ExactNumber& y,
                const ExactNumber& w) {
  const ExactPlane p(a), q(b);
  const ExactNumber difference =
      exact_value(q, x, y, w) * p.normal.z - exact_value(p, x, y, w) * q.normal.z;
  return difference.sign() * p.normal.z.sign() * q.normal.z.sign() * w.sign();
}

/// True, and counted, if the planes are the same by definition.
bool same_plane(const Plane& a, const Plane& b, Predicate predicate) {
  if (!a.same_points(b)) return false;
  count_by_definition(predicate);
  return true;
}

}  // namespace

double exact_depth(const Plane& plane, const PixelCentre& centre) {
  const ExactProjector through(centre);
  const ExactPlane exact(plane);
  return rounded_quotient(-exact_value(exact, through.x, through.y, through.w),
                          exact.normal.z * through.w);
}

int exact_depth_order(const Plane& a, const Plane& b, const PixelCentre& centre) {
  if (same_plane(a, b, Predicate::depth_at_pixel)) return 0;
  count_exact(Predicate::depth_at_pixel);
  const ExactProjector through(centre);
  return exact_order(a, b, through.x, through.y, through.w);
}

int exact_depth_order(const Plane& a, const Plane& b, const Point2& at) {
  if (same_plane(a, b, Predicate::depth_at_point)) return 0;
  if (is_double_double_sound()) {
    const PlaneEstimate first(a), second(b);
    const int sign = decided_sign(estimated_apart(first, second, at));
    if (sign != 0) return sign * facing(a) * facing(b);
  }
  count_exact(Predicate::depth_at_point);
  const ExactProjector through(at);
  return exact_order(a, b, through.x, through.y, through.w);
}

int exact_depth_order(const Definitions& all, const Plane& a, const Plane& b,
                      const DefinedPoint& at) {
  if (same_plane(a, b, Predicate::depth_at_point)) return 0;
  count_exact(Predicate::depth_at_point);
  const ExactPoint point = exact_point(all, at);
  return exact_order(a, b, point.xyz.x, point.xyz.y, point.w);
}

}  // namespace displayfile
