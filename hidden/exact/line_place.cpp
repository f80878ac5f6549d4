#include "hidden/exact/line_place.h"

#include <cassert>
#include <optional>

#include "hidden/exact/line_estimates.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

/// a + t (b - a) with t = at_a / (at_a - at_b), rounded; nothing if the errors do not determine it.
std::optional<Point2> rounded_point(const Point2& a, const Point2& b, const Estimate& at_a,
                                    const Estimate& at_b) {
  constexpr double kSum = 0x1p-101;
  const auto share = estimated_share(at_a, at_b);
  if (!share) return std::nullopt;
  Point2 place(0.0);
  for (int axis = 0; axis < 2; ++axis) {
    const DoubleDouble along = exact_difference(b[axis], a[axis]), way = share->t * along;
    const DoubleDouble at = DoubleDouble{a[axis], 0.0} + way;
    const double error =
        (share->error * std::abs(along.high) + kSum * (std::abs(a[axis]) + std::abs(way.high))) *
            (1.0 + 0x1p-20) +
        kTiny;
    const auto rounded = rounded_sum(at, error);
    if (!rounded) return std::nullopt;
    place[axis] = *rounded + 0.0;
  }
  return place;
}

/// a + t (b - a), exactly.
ExactPlace place_along(const Point2& a, const Point2& b, const ExactNumber& part,
                       const ExactNumber& whole) {
  const auto along = [&](int axis) {
    return ExactNumber(a[axis]) * whole + part * exactly_apart(b[axis], a[axis]);
  };
  return {along(0), along(1), whole};
}

}  // namespace

ExactPlace exact_place(const Point2& p) {
  return {ExactNumber(p.x), ExactNumber(p.y), ExactNumber(1.0)};
}

ExactPlace exact_crossing_place(const Point2& a, const Point2& b, const Point2& p,
                                const Point2& q) {
  const ExactNumber at_a = exact_turn(p, q, a);
  return place_along(a, b, at_a, at_a - exact_turn(p, q, b));
}

ExactPlace exact_meeting_place(const Point2& a, const Point2& b, const Plane& one,
                               const Plane& other) {
  const ExactDepths depths(one, other);
  const ExactNumber at_a = depths.apart(a);
  return place_along(a, b, at_a, at_a - depths.apart(b));
}

Point2 rounded(const ExactPlace& place) {
  return Point2(rounded_quotient(place.x, place.w), rounded_quotient(place.y, place.w)) + 0.0;
}

int compare_xy(const ExactPlace& p, const ExactPlace& q) {
  assert(p.w.sign() != 0 && q.w.sign() != 0);
  const int way = p.w.sign() * q.w.sign();
  const int by_x = (p.x * q.w - q.x * p.w).sign() * way;
  return by_x != 0 ? by_x : (p.y * q.w - q.y * p.w).sign() * way;
}

int orientation(const ExactPlace& p, const ExactPlace& q, const ExactPlace& r) {
  assert(p.w.sign() != 0 && q.w.sign() != 0 && r.w.sign() != 0);
  const ExactNumber turn =
      p.x * (q.y * r.w - r.y * q.w) - p.y * (q.x * r.w - r.x * q.w) + p.w * (q.x * r.y - r.x * q.y);
  return turn.sign() * p.w.sign() * q.w.sign() * r.w.sign();
}

Point2 crossing_place(const Point2& a, const Point2& b, const Point2& p, const Point2& q) {
  if (is_double_double_sound()) {
    const DoubleDouble dx = exact_difference(q.x, p.x), dy = exact_difference(q.y, p.y);
    const auto place =
        rounded_point(a, b, estimated_turn(p, dx, dy, a), estimated_turn(p, dx, dy, b));
    if (place) return *place;
  }
  count_exact(Predicate::line_parameter);
  return rounded(exact_crossing_place(a, b, p, q));
}

Point2 meeting_place(const Point2& a, const Point2& b, const Plane& one, const Plane& other) {
  if (is_double_double_sound()) {
    const PlaneEstimate first(one), second(other);
    const auto place =
        rounded_point(a, b, estimated_apart(first, second, a), estimated_apart(first, second, b));
    if (place) return *place;
  }
  count_exact(Predicate::line_parameter);
  return rounded(exact_meeting_place(a, b, one, other));
}

}  // namespace displayfile
