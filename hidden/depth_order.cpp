#include "hidden/depth_order.h"

#include <algorithm>
#include <optional>

#include "hidden/ball.h"
#include "hidden/exact_point.h"
#include "hidden/predicate_counts.h"

namespace displayfile {

namespace {

/// A (x - p.x) + B (y - p.y): the plane's z is p.z less this, over C.
Ball slope_value(const Plane& plane, const Ball& x, const Ball& y) {
  return Ball{plane.normal.x, plane.bound.x} * (x - Ball{plane.p.x, 0.0}) +
         Ball{plane.normal.y, plane.bound.y} * (y - Ball{plane.p.y, 0.0});
}

/// The filter: (za - zb) Ca Cb, without a quotient. Heights of the planes' own points are
/// subtracted first, so that level planes are told apart however close.
std::optional<int> filtered_order(const Plane& a, const Plane& b, const Ball& x, const Ball& y) {
  constexpr double kLargestFactor = 0x1p+330;  // three of them are far below the largest double
  const Ball ca = {a.normal.z, a.bound.z}, cb = {b.normal.z, b.bound.z};
  if (!decided(ca) || !decided(cb)) return std::nullopt;
  const Ball at_a = slope_value(a, x, y), at_b = slope_value(b, x, y);
  const Ball apart = ball_of_difference(a.p.z, b.p.z);
  const double largest = std::max(std::max(std::max(std::abs(ca.middle), std::abs(cb.middle)),
                                           std::max(std::abs(at_a.middle), std::abs(at_b.middle))),
                                  std::abs(apart.middle));
  if (!(largest <= kLargestFactor)) return std::nullopt;
  const Ball difference = apart * ca * cb - at_a * cb + at_b * ca;
  if (!decided(difference)) return std::nullopt;
  return sign_of(difference.middle) * sign_of(ca.middle) * sign_of(cb.middle);
}

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

/// A quotient that was rounded once, as an enclosure.
Ball rounded_once(double value) { return {value, kUnit * std::abs(value) * kInflate + kTiny}; }

/// True, and counted, if the planes are the same by definition.
bool same_plane(const Plane& a, const Plane& b, Predicate predicate) {
  if (!a.same_points(b)) return false;
  count_by_definition(predicate);
  return true;
}

}  // namespace

int depth_order(const Plane& a, const Plane& b, const PixelCentre& centre) {
  if (const auto order = filtered_order(a, b, rounded_once(centre.x), rounded_once(centre.y))) {
    return *order;
  }
  if (same_plane(a, b, Predicate::depth_at_pixel)) return 0;
  count_exact(Predicate::depth_at_pixel);
  const std::int64_t width = centre.size.width, height = centre.size.height;
  return exact_order(a, b, ExactNumber(2 * std::int64_t{centre.column} + 1) * ExactNumber(height),
                     ExactNumber(2 * std::int64_t{centre.row} + 1) * ExactNumber(width),
                     ExactNumber(2 * width) * ExactNumber(height));
}

int depth_order(const Plane& a, const Plane& b, const Point2& at) {
  if (const auto order = filtered_order(a, b, Ball{at.x, 0.0}, Ball{at.y, 0.0})) return *order;
  if (same_plane(a, b, Predicate::depth_at_point)) return 0;
  count_exact(Predicate::depth_at_point);
  return exact_order(a, b, ExactNumber(at.x), ExactNumber(at.y), ExactNumber(1.0));
}

int depth_order(const Definitions& all, const Plane& a, const Plane& b, const DefinedPoint& at) {
  const Ball x = {at.near.x, at.radius}, y = {at.near.y, at.radius};
  if (const auto order = filtered_order(a, b, x, y)) return *order;
  if (same_plane(a, b, Predicate::depth_at_point)) return 0;
  count_exact(Predicate::depth_at_point);
  const ExactPoint point = exact_point(all, at);
  return exact_order(a, b, point.xyz.x, point.xyz.y, point.w);
}

}  // namespace displayfile
