// Where along a line something meets it (hidden/exact/line_parameter.h), judged by rationals: on
// random input and on constructions on a grid, in every rounding mode.

#include "hidden/exact/line_parameter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "hidden/exact/predicate_counts.h"
#include "tests/predicate_inputs.h"
#include "tests/rational_points.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using namespace test;

/// Twice how far the double is from the exact value, cut off at 0 and 1, is no more than the space
/// to its neighbour there; and if it is that, its last digit is even.
bool is_nearest(double value, Q exact_value) {
  if (exact_value <= 0) return value == 0.0;
  if (exact_value >= 1) return value == 1.0;
  const Q off = exact_value - scaled(value, 0);
  const double other =
      std::nextafter(value, sgn(off) < 0 ? -1.0 : std::numeric_limits<double>::infinity());
  const Q to_other = abs(exact_value - scaled(other, 0));
  if (abs(off) != to_other) return abs(off) < to_other;
  int exponent = 0;
  return std::fmod(std::ldexp(std::frexp(value, &exponent), 53), 2.0) == 0.0;
}

/// Points for one trial: anything, or on a grid and nudged.
struct Trial {
  explicit Trial(Source& s) : style(s, true), grid(s), is_on_grid(s.below(2) == 0) {}
  Point3 point(Source& s) const {
    return is_on_grid ? grid.place(s, step(s, step_size(s))) : style.point(s);
  }
  Style style;
  Grid grid;
  bool is_on_grid;
};

QPoint of(const Point3& p) { return exact(p, 0); }

template <class Find>
double found_in_mode(int mode, const Find& find) {
  double t = 0.0;
  in_mode(mode, [&] {
    t = find();
    return 0;
  });
  return t;
}

int mode_of(Source& s) { return s.below(2) == 0 ? FE_TONEAREST : kModes[s.bits() % 4]; }

const long kTrials = trials() / kSlower;

TEST(LineParameters, Crossings) {
  Source s(1);
  for (long k = 0; k < kTrials; ++k) {
    const Trial trial(s);
    const Point3 a = trial.point(s), b = trial.point(s), p = trial.point(s), q = trial.point(s);
    const Q at_a = turn(of(p), of(q), of(a)), whole = at_a - turn(of(p), of(q), of(b));
    if (whole == 0) continue;
    const double t = found_in_mode(
        mode_of(s), [&] { return crossing_parameter(Point2(a), Point2(b), Point2(p), Point2(q)); });
    ASSERT_TRUE(is_nearest(t, at_a / whole)) << k << hex(a) << hex(b) << hex(p) << hex(q) << t;
    ASSERT_EQ(t, exact_crossing_parameter(Point2(a), Point2(b), Point2(p), Point2(q)));
  }
}

TEST(LineParameters, PointsOfTheLine) {
  Source s(2);
  for (long k = 0; k < kTrials; ++k) {
    const Trial trial(s);
    const Point3 a = trial.point(s), b = trial.point(s), p = trial.point(s);
    // Along one axis, where any point lies on the line.
    const Point2 from(a.x, 0.0), to(b.x, 0.0), at(p.x, 0.0);
    if (a.x == b.x) continue;
    const double t = found_in_mode(mode_of(s), [&] { return point_parameter(from, to, at); });
    const Q exact_t = (of(p).x - of(a).x) / (of(b).x - of(a).x);
    ASSERT_TRUE(is_nearest(t, exact_t)) << k << hex(a) << hex(b) << hex(p) << t;
    ASSERT_EQ(point_parameter({0.0, a.x}, {0.0, b.x}, {0.0, p.x}), t);  // along the other axis
  }
}

TEST(LineParameters, MeetingsWithAPlane) {
  Source s(3);
  for (long k = 0; k < kTrials; ++k) {
    const Trial trial(s);
    const Point3 a = trial.point(s), b = trial.point(s), p = trial.point(s), q = trial.point(s),
                 r = trial.point(s);
    const QPlane plane(of(p), of(q), of(r));
    const Q at_a = plane.at(of(a)), at_b = plane.at(of(b));
    if (sgn(at_a) * sgn(at_b) >= 0) continue;
    const double t =
        found_in_mode(mode_of(s), [&] { return meeting_parameter(a, b, Plane(p, q, r)); });
    ASSERT_TRUE(is_nearest(t, at_a / (at_a - at_b)))
        << k << hex(a) << hex(b) << hex(p) << hex(q) << hex(r) << t;
  }
}

TEST(LineParameters, MeetingsOfTwoPlanesAboveALine) {
  Source s(4);
  for (long k = 0; k < kTrials / 10; ++k) {
    const Trial trial(s);
    std::array<Point3, 8> v;
    for (Point3& point : v) point = trial.point(s);
    const QPlane one(of(v[2]), of(v[3]), of(v[4])), other(of(v[5]), of(v[6]), of(v[7]));
    if (one.c == 0 || other.c == 0) continue;
    const QPoint a = of(v[0]), b = of(v[1]);
    const Q at_a = one.z(a.x, a.y) - other.z(a.x, a.y), at_b = one.z(b.x, b.y) - other.z(b.x, b.y);
    if (sgn(at_a) * sgn(at_b) >= 0) continue;
    const double t = found_in_mode(mode_of(s), [&] {
      return meeting_parameter(Point2(v[0]), Point2(v[1]), Plane(v[2], v[3], v[4]),
                               Plane(v[5], v[6], v[7]));
    });
    ASSERT_TRUE(is_nearest(t, at_a / (at_a - at_b))) << k << t;
  }
}

TEST(LineParameters, TheMiddleStageLeavesNothingOrdinaryToTheExactOne) {
  Source s(5);
  reset_predicate_counts();
  for (int k = 0; k < 10000; ++k) {
    const auto point = [&] {
      const double x = s.unit(), y = s.unit(), z = s.unit();
      return Point3(x, y, z);
    };
    const Point3 a = point(), b = point(), p = point(), q = point(), r = point();
    crossing_parameter(Point2(a), Point2(b), Point2(p), Point2(q));
    meeting_parameter(a, b, Plane(p, q, r));
  }
  const auto counts = predicate_counts();
  EXPECT_EQ(counts[static_cast<std::size_t>(Predicate::line_parameter)].exact, 0u);
}

}  // namespace
}  // namespace displayfile
