#include "hidden/exact/line_parameter.h"

#include <cassert>
#include <optional>

#include "hidden/exact/exact_vector.h"
#include "hidden/exact/line_estimates.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

/// at_a / (at_a - at_b), clamped and rounded; nothing if the errors do not determine it.
std::optional<double> rounded_share(const Estimate& at_a, const Estimate& at_b) {
  const auto share = estimated_share(at_a, at_b);
  if (!share) return std::nullopt;
  // Beyond an end only the side is needed.
  if (share->t.high + (share->t.low + share->error) <= 0.0) return 0.0;
  if (share->t.high + (share->t.low - share->error) >= 1.0) return 1.0;
  return rounded_sum(share->t, share->error);
}

/// part / whole, clamped and rounded.
double exact_share(const ExactNumber& part, const ExactNumber& whole) {
  count_exact(Predicate::line_parameter);
  if (part.sign() * whole.sign() <= 0) return 0.0;
  if ((part - whole).sign() * whole.sign() >= 0) return 1.0;
  const double share = rounded_quotient(part, whole);
  assert(0.0 <= share && share <= 1.0);
  return share;
}

// For ends that are not doubles; defined below.
Estimate estimated_turn(const Point2& p, const DoubleDouble& dx, const DoubleDouble& dy,
                        const DefinedEnd& v);
Estimate estimated_value(const Plane& plane, const DefinedEnd& v);

/// Shared by both kinds of ends: estimates first, then exact numbers if these are undecided.
template <class End>
double crossing_between(const End& a, const End& b, const Point2& p, const Point2& q) {
  if (is_double_double_sound()) {
    const DoubleDouble dx = exact_difference(q.x, p.x), dy = exact_difference(q.y, p.y);
    const auto t = rounded_share(estimated_turn(p, dx, dy, a), estimated_turn(p, dx, dy, b));
    if (t) return *t;
  }
  return exact_crossing_parameter(a, b, p, q);
}

template <class End>
double meeting_between(const End& a, const End& b, const Plane& plane) {
  if (is_double_double_sound()) {
    const auto t = rounded_share(estimated_value(plane, a), estimated_value(plane, b));
    if (t) return *t;
  }
  return exact_meeting_parameter(a, b, plane);
}

}  // namespace

double exact_crossing_parameter(const Point2& a, const Point2& b, const Point2& p,
                                const Point2& q) {
  const ExactNumber at_a = exact_turn(p, q, a);
  return exact_share(at_a, at_a - exact_turn(p, q, b));
}

double slow_crossing_parameter(const Point2& a, const Point2& b, const Point2& p, const Point2& q) {
  return crossing_between(a, b, p, q);
}

double exact_point_parameter(const Point2& a, const Point2& b, const Point2& p) {
  const int axis = a.x != b.x ? 0 : 1;
  return exact_share(exactly_apart(p[axis], a[axis]), exactly_apart(b[axis], a[axis]));
}

double point_parameter(const Point2& a, const Point2& b, const Point2& p) {
  assert(a != b);
  if (p == a) return 0.0;
  if (p == b) return 1.0;
  const int axis = a.x != b.x ? 0 : 1;
  if (is_double_double_sound()) {
    const auto t = rounded_share({exact_difference(p[axis], a[axis]), 0.0},
                                 {exact_difference(p[axis], b[axis]), 0.0});
    if (t) return *t;
  }
  return exact_point_parameter(a, b, p);
}

double exact_meeting_parameter(const Point3& a, const Point3& b, const Plane& plane) {
  const ExactPlane exact(plane);
  const auto value = [&](const Point3& v) { return value_at(exact, exact_point(v)); };
  const ExactNumber at_a = value(a);
  return exact_share(at_a, at_a - value(b));
}

double meeting_parameter(const Point3& a, const Point3& b, const Plane& plane) {
  return meeting_between(a, b, plane);
}

double exact_meeting_parameter(const Point2& a, const Point2& b, const Plane& one,
                               const Plane& other) {
  const ExactDepths depths(one, other);
  const ExactNumber at_a = depths.apart(a);
  return exact_share(at_a, at_a - depths.apart(b));
}

double meeting_parameter(const Point2& a, const Point2& b, const Plane& one, const Plane& other) {
  if (is_double_double_sound()) {
    const PlaneEstimate first(one), second(other);
    const auto t =
        rounded_share(estimated_apart(first, second, a), estimated_apart(first, second, b));
    if (t) return *t;
  }
  return exact_meeting_parameter(a, b, one, other);
}

// ---- Lines whose ends are not doubles -------------------------------------------------------

namespace {

/// Allows for coordinates so small that their second double underflows: 2^-1074 is far below this.
constexpr double kLeastSize = 0x1p-900;

DoubleDouble rounded_twice(const ExactNumber& value, const ExactNumber& w) {
  const double high = rounded_quotient(value, w);
  return {high, rounded_quotient(value - ExactNumber(high) * w, w)};
}

/// v's coordinate minus a double, and the size that bounds its error. Digits cancel if the two are
/// close.
struct EndDifference {
  EndDifference(const DefinedEnd& v, int axis, double from)
      : value(v.close[static_cast<std::size_t>(axis)] - DoubleDouble{from, 0.0}),
        size(std::abs(v.close[static_cast<std::size_t>(axis)].high) + std::abs(from) + kLeastSize) {
  }
  static constexpr double kError = 0x1p-102;  // relative to the size
  DoubleDouble value;
  double size;
};

/// d x (v - p).
Estimate estimated_turn(const Point2& p, const DoubleDouble& dx, const DoubleDouble& dy,
                        const DefinedEnd& v) {
  constexpr double kError = 0x1p-100;
  const EndDifference x(v, 0, p.x), y(v, 1, p.y);
  return {dx * y.value - dy * x.value,
          kError * (std::abs(dx.high) * y.size + std::abs(dy.high) * x.size) + kTiny};
}

Estimate estimated_value(const Plane& plane, const DefinedEnd& v) {
  constexpr double kError = 0x1p-97, kUnderflow = 0x1p-700;
  if (!plane.is_plain()) return {{}, kNothingKnown};
  DoubleDouble sum;
  double error = kUnderflow;
  for (int i = 0; i < 3; ++i) {
    const EndDifference from(v, i, plane.p[i]);
    const DoubleDouble normal = normal_along(plane, i);
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double largest = reach_along(plane, plane.p[j], j) * reach_along(plane, plane.p[k], k);
    sum = sum + normal * from.value;
    error += kError * (largest * from.size);
  }
  return {sum, error};
}

Estimate estimated_place(const Point2& p, int axis, const DefinedEnd& v) {
  const EndDifference from(v, axis, p[axis]);
  return {-from.value, EndDifference::kError * from.size};
}

/// at_a / a.w over at_a / a.w - at_b / b.w.
double exact_share(const ExactNumber& at_a, const DefinedEnd& a, const ExactNumber& at_b,
                   const DefinedEnd& b) {
  const ExactNumber part = at_a * b.exact.w;
  return exact_share(part, part - at_b * a.exact.w);
}

/// An axis along which the ends differ, in the projection.
int axis_of(const DefinedEnd& a, const DefinedEnd& b) {
  return a.close[0].high != b.close[0].high ? 0 : 1;
}

}  // namespace

DefinedEnd::DefinedEnd(const Definitions& all, const DefinedPoint& v)
    : exact(exact_point(all, v)),
      close{rounded_twice(exact.xyz.x, exact.w), rounded_twice(exact.xyz.y, exact.w),
            rounded_twice(exact.xyz.z, exact.w)} {}

double exact_crossing_parameter(const DefinedEnd& a, const DefinedEnd& b, const Point2& p,
                                const Point2& q) {
  const ExactNumber dx = exactly_apart(q.x, p.x), dy = exactly_apart(q.y, p.y);
  const auto turn = [&](const ExactPoint& v) {
    return dx * (v.xyz.y - ExactNumber(p.y) * v.w) - dy * (v.xyz.x - ExactNumber(p.x) * v.w);
  };
  return exact_share(turn(a.exact), a, turn(b.exact), b);
}

double crossing_parameter(const DefinedEnd& a, const DefinedEnd& b, const Point2& p,
                          const Point2& q) {
  return crossing_between(a, b, p, q);
}

double exact_point_parameter(const DefinedEnd& a, const DefinedEnd& b, const Point2& p) {
  const int axis = axis_of(a, b);
  const auto place = [&](const ExactPoint& v) {
    return ExactNumber(p[axis]) * v.w - (axis == 0 ? v.xyz.x : v.xyz.y);
  };
  return exact_share(place(a.exact), a, place(b.exact), b);
}

double point_parameter(const DefinedEnd& a, const DefinedEnd& b, const Point2& p) {
  const int axis = axis_of(a, b);
  if (is_double_double_sound()) {
    const auto t = rounded_share(estimated_place(p, axis, a), estimated_place(p, axis, b));
    if (t) return *t;
  }
  return exact_point_parameter(a, b, p);
}

double exact_meeting_parameter(const DefinedEnd& a, const DefinedEnd& b, const Plane& plane) {
  const ExactPlane exact(plane);
  return exact_share(value_at(exact, a.exact), a, value_at(exact, b.exact), b);
}

double meeting_parameter(const DefinedEnd& a, const DefinedEnd& b, const Plane& plane) {
  return meeting_between(a, b, plane);
}

}  // namespace displayfile
