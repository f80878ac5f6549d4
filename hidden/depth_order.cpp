#include "hidden/depth_order.h"

#include <algorithm>
#include <optional>

#include "hidden/exact_point.h"
#include "hidden/predicate_counts.h"

namespace displayfile {

namespace {

/// A position of the projection, each coordinate within `error` of the true one.
struct Position {
  double x, y, error;
};

/// A (x - p.x) + B (y - p.y), with its bound: the plane's z is p.z less this over C.
PlaneValue slope_value(const Plane& plane, const Position& at) {
  const double x = at.x - plane.p.x, y = at.y - plane.p.y;
  const double value = plane.normal.x * x + plane.normal.y * y;
  const double moved =
      std::abs(plane.normal.x) + std::abs(plane.normal.y) + plane.bound.x + plane.bound.y;
  const double bound = plane.bound.x * std::abs(x) + plane.bound.y * std::abs(y) +
                       at.error * moved * kInflate + kTiny;
  return {value, bound};
}

/// The filter: (za - zb) Ca Cb, without a quotient. Heights of the planes' own points are
/// subtracted first, so that level planes are told apart however close.
std::optional<int> filtered_order(const Plane& a, const Plane& b, const Position& at) {
  constexpr double kLargestFactor = 0x1p+330;  // three of them are far below the largest double
  const double ca = a.normal.z, cb = b.normal.z;
  const double most_ca = std::abs(ca) + a.bound.z, most_cb = std::abs(cb) + b.bound.z;
  const PlaneValue at_a = slope_value(a, at), at_b = slope_value(b, at);
  const double apart = a.p.z - b.p.z;
  const double difference = apart * ca * cb - at_a.value * cb + at_b.value * ca;
  const double bound = most_cb * (a.bound.z * std::abs(apart) + at_a.bound) +
                       most_ca * (b.bound.z * std::abs(apart) + at_b.bound) +
                       b.bound.z * std::abs(at_a.value) + a.bound.z * std::abs(at_b.value);
  const double largest = std::max(std::max(std::max(most_ca, most_cb), std::abs(apart)),
                                  std::max(std::abs(at_a.value), std::abs(at_b.value)));
  const bool decided = std::abs(difference) > bound * kInflate + kTiny &&
                       std::abs(ca) > a.bound.z && std::abs(cb) > b.bound.z &&
                       largest <= kLargestFactor;
  if (!decided) return std::nullopt;
  return decided_sign(difference) * decided_sign(ca) * decided_sign(cb);
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

/// True, and counted, if the planes are the same by definition.
bool same_plane(const Plane& a, const Plane& b, Predicate predicate) {
  if (!a.same_points(b)) return false;
  count_by_definition(predicate);
  return true;
}

}  // namespace

int depth_order(const Plane& a, const Plane& b, const PixelCentre& centre) {
  if (const auto order = filtered_order(a, b, {centre.x, centre.y, centre.error})) {
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
  if (const auto order = filtered_order(a, b, {at.x, at.y, 0.0})) return *order;
  if (same_plane(a, b, Predicate::depth_at_point)) return 0;
  count_exact(Predicate::depth_at_point);
  return exact_order(a, b, ExactNumber(at.x), ExactNumber(at.y), ExactNumber(1.0));
}

int depth_order(const Definitions& all, const Plane& a, const Plane& b, const DefinedPoint& at) {
  if (const auto order = filtered_order(a, b, {at.near.x, at.near.y, at.radius})) return *order;
  if (same_plane(a, b, Predicate::depth_at_point)) return 0;
  count_exact(Predicate::depth_at_point);
  const ExactPoint point = exact_point(all, at);
  return exact_order(a, b, point.xyz.x, point.xyz.y, point.w);
}

}  // namespace displayfile
