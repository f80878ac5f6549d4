#include "hidden/exact/line_parameter.h"

#include <cfenv>
#include <cfloat>
#include <limits>
#include <optional>

#include "hidden/exact/exact_vector.h"
#include "hidden/exact/predicate_counts.h"

namespace displayfile {

namespace {

// ---- The middle stage ---------------------------------------------------------------------

/// A value and by how much it may be off, before the quotient.
struct Estimate {
  DoubleDouble value;
  double error;
};

constexpr double kNothingKnown = std::numeric_limits<double>::infinity();

/// Double-double arithmetic errs by as much as is said only in rounding to nearest, to doubles.
bool is_double_double_sound() { return FLT_EVAL_METHOD == 0 && std::fegetround() == FE_TONEAREST; }

/// at_a / (at_a - at_b), cut off and rounded; nothing if that depends on what may be off.
std::optional<double> rounded_share(const Estimate& at_a, const Estimate& at_b) {
  constexpr double kDifference = 0x1p-103, kQuotient = 0x1p-100;
  const DoubleDouble whole = at_a.value - at_b.value;
  const double error_of_whole =
      at_a.error + at_b.error +
      kDifference * (std::abs(at_a.value.high) + std::abs(at_b.value.high));
  const double least = std::abs(whole.high) - error_of_whole * kInflate;
  if (!(least > 0.5 * std::abs(whole.high))) return std::nullopt;
  const DoubleDouble t = at_a.value / whole;
  const double size = std::abs(t.high);
  const double error =
      ((at_a.error + size * error_of_whole + kTiny) / least + size * kQuotient) * (1.0 + 0x1p-20) +
      kTiny;
  const double low = t.high + (t.low - error), high = t.high + (t.low + error);
  // Beyond an end it need not be known.
  if (high <= 0.0) return 0.0;
  if (low >= 1.0) return 1.0;
  if (low != high) return std::nullopt;  // false for NaN, where something overflowed
  return low;
}

/// d x (v - p).
Estimate estimated_turn(const Point2& p, const DoubleDouble& dx, const DoubleDouble& dy,
                        const Point2& v) {
  constexpr double kError = 0x1p-101;
  const DoubleDouble left = dx * exact_difference(v.y, p.y);
  const DoubleDouble right = dy * exact_difference(v.x, p.x);
  return {left - right, kError * (std::abs(left.high) + std::abs(right.high)) + kTiny};
}

/// How far a plane's points, and another, lie from its first along an axis.
double reach(const Plane& plane, double at, int axis) {
  return std::max({std::abs(plane.q[axis] - plane.p[axis]), std::abs(plane.r[axis] - plane.p[axis]),
                   std::abs(at - plane.p[axis])});
}

/// One component of the plane's normal.
DoubleDouble normal_along(const Plane& plane, int axis) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const auto side = [&](const Point3& end, int i) { return exact_difference(end[i], plane.p[i]); };
  return side(plane.q, j) * side(plane.r, k) - side(plane.q, k) * side(plane.r, j);
}

/// The plane's value at v.
Estimate estimated_value(const Plane& plane, const Point3& v) {
  constexpr double kError = 0x1p-97;
  constexpr double kUnderflow = 0x1p-700;
  DoubleDouble sum;
  for (int i = 0; i < 3; ++i) {
    sum = sum + normal_along(plane, i) * exact_difference(v[i], plane.p[i]);
  }
  const double size = reach(plane, v.x, 0) * (reach(plane, v.y, 1) * reach(plane, v.z, 2));
  return {sum, kError * size + kUnderflow};
}

/// What the depths of planes are compared by.
struct PlaneEstimate {
  explicit PlaneEstimate(const Plane& plane_)
      : plane(plane_),
        a(normal_along(plane_, 0)),
        b(normal_along(plane_, 1)),
        c(normal_along(plane_, 2)) {}
  /// A (x - p.x) + B (y - p.y).
  DoubleDouble slope(const Point2& at) const {
    return a * exact_difference(at.x, plane.p.x) + b * exact_difference(at.y, plane.p.y);
  }
  const Plane& plane;
  DoubleDouble a, b, c;
};

/// The difference of two planes' depths times both C.
Estimate estimated_apart(const PlaneEstimate& one, const PlaneEstimate& other, const Point2& at) {
  constexpr double kError = 0x1p-97, kUnderflow = 0x1p-600, kLargestFigure = 0x1p+100;
  const DoubleDouble apart = exact_difference(one.plane.p.z, other.plane.p.z);
  const DoubleDouble value =
      apart * one.c * other.c - one.slope(at) * other.c + other.slope(at) * one.c;
  const auto flat = [&](const Plane& p) { return reach(p, at.x, 0) * reach(p, at.y, 1); };
  const double flat_one = flat(one.plane), flat_other = flat(other.plane);
  const double high_one = reach(one.plane, one.plane.p.z, 2);
  const double high_other = reach(other.plane, other.plane.p.z, 2);
  const double high = std::abs(apart.high) + high_one + high_other;
  // Larger figures could make much of what is lost to underflow.
  if (!(std::max(std::max(flat_one, flat_other), high) < kLargestFigure))
    return {value, kNothingKnown};
  return {value, kError * (flat_one * flat_other * high) + kUnderflow};
}

// ---- The exact stage ----------------------------------------------------------------------

/// part / whole, cut off and rounded.
double exact_share(const ExactNumber& part, const ExactNumber& whole) {
  count_exact(Predicate::line_parameter);
  if (part.sign() * whole.sign() <= 0) return 0.0;
  if ((part - whole).sign() * whole.sign() >= 0) return 1.0;
  return rounded_quotient(part, whole);
}

ExactNumber exactly_apart(double a, double b) { return ExactNumber(a) - ExactNumber(b); }

ExactNumber exact_turn(const Point2& a, const Point2& b, const Point2& c) {
  return exactly_apart(b.x, a.x) * exactly_apart(c.y, a.y) -
         exactly_apart(b.y, a.y) * exactly_apart(c.x, a.x);
}

/// C times the plane's depth at a point of the projection.
ExactNumber exact_depth(const ExactPlane& plane, const Point2& at) {
  return plane.normal.z * plane.through.z - plane.normal.x * (ExactNumber(at.x) - plane.through.x) -
         plane.normal.y * (ExactNumber(at.y) - plane.through.y);
}

}  // namespace

double exact_crossing_parameter(const Point2& a, const Point2& b, const Point2& p,
                                const Point2& q) {
  const ExactNumber at_a = exact_turn(p, q, a);
  return exact_share(at_a, at_a - exact_turn(p, q, b));
}

double slow_crossing_parameter(const Point2& a, const Point2& b, const Point2& p, const Point2& q) {
  if (is_double_double_sound()) {
    const DoubleDouble dx = exact_difference(q.x, p.x), dy = exact_difference(q.y, p.y);
    const auto t = rounded_share(estimated_turn(p, dx, dy, a), estimated_turn(p, dx, dy, b));
    if (t) return *t;
  }
  return exact_crossing_parameter(a, b, p, q);
}

double exact_point_parameter(const Point2& a, const Point2& b, const Point2& p) {
  const int axis = a.x != b.x ? 0 : 1;
  return exact_share(exactly_apart(p[axis], a[axis]), exactly_apart(b[axis], a[axis]));
}

double point_parameter(const Point2& a, const Point2& b, const Point2& p) {
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
  const auto value = [&](const Point3& v) {
    return dot(exact.normal, exact_difference(v, plane.p));
  };
  const ExactNumber at_a = value(a);
  return exact_share(at_a, at_a - value(b));
}

double meeting_parameter(const Point3& a, const Point3& b, const Plane& plane) {
  if (is_double_double_sound()) {
    const auto t = rounded_share(estimated_value(plane, a), estimated_value(plane, b));
    if (t) return *t;
  }
  return exact_meeting_parameter(a, b, plane);
}

double exact_meeting_parameter(const Point2& a, const Point2& b, const Plane& one,
                               const Plane& other) {
  const ExactPlane first(one), second(other);
  const auto apart = [&](const Point2& at) {
    return exact_depth(first, at) * second.normal.z - exact_depth(second, at) * first.normal.z;
  };
  const ExactNumber at_a = apart(a);
  return exact_share(at_a, at_a - apart(b));
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

// ---- Lines whose ends are no doubles --------------------------------------------------------

namespace {

/// Coordinates may be smaller than their second double can say: 2^-1074 is far less than this.
constexpr double kLeastSize = 0x1p-900;

DoubleDouble rounded_twice(const ExactNumber& value, const ExactNumber& w) {
  const double high = rounded_quotient(value, w);
  return {high, rounded_quotient(value - ExactNumber(high) * w, w)};
}

/// v's coordinate less a double, and what bounds its error: both lose digits where they are close.
struct EndDifference {
  EndDifference(const DefinedEnd& v, int axis, double from)
      : value(v.close[static_cast<std::size_t>(axis)] - DoubleDouble{from, 0.0}),
        size(std::abs(v.close[static_cast<std::size_t>(axis)].high) + std::abs(from) + kLeastSize) {
  }
  static constexpr double kError = 0x1p-102;  // of the size
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
  DoubleDouble sum;
  double error = kUnderflow;
  for (int i = 0; i < 3; ++i) {
    const EndDifference from(v, i, plane.p[i]);
    const DoubleDouble normal = normal_along(plane, i);
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double largest = reach(plane, plane.p[j], j) * reach(plane, plane.p[k], k);
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
  if (is_double_double_sound()) {
    const DoubleDouble dx = exact_difference(q.x, p.x), dy = exact_difference(q.y, p.y);
    const auto t = rounded_share(estimated_turn(p, dx, dy, a), estimated_turn(p, dx, dy, b));
    if (t) return *t;
  }
  return exact_crossing_parameter(a, b, p, q);
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
  if (is_double_double_sound()) {
    const auto t = rounded_share(estimated_value(plane, a), estimated_value(plane, b));
    if (t) return *t;
  }
  return exact_meeting_parameter(a, b, plane);
}

}  // namespace displayfile
