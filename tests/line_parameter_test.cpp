// Where along a line something meets it (hidden/exact/line_parameter.h), judged by rationals: on
// random input and on constructions on a grid, in every rounding mode.

#include "hidden/exact/line_parameter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "hidden/exact/common_line.h"
#include "hidden/exact/predicate_counts.h"
#include "tests/predicate_inputs.h"
#include "tests/rational_points.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using namespace test;

/// Twice the distance of the double from the exact value, cut off at 0 and 1, is no more than the
/// space to its neighbour there; and if it is that, its last digit is even.
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

/// The line of two triangles' planes between two sides of the first, and its rationals.
struct LineOfPlanes {
  LineOfPlanes(const Trial& trial, Source& s) {
    for (Point3& p : points) p = trial.point(s);
    planes = {Plane(points[0], points[1], points[2]), Plane(points[3], points[4], points[5])};
    const QPlane second(of(points[3]), of(points[4]), of(points[5]));
    const QPlane first(of(points[0]), of(points[1]), of(points[2]));
    if (first.c == 0 || second.c == 0) return;
    const auto start = meet(of(points[0]), of(points[1]), second);
    const auto end = meet(of(points[0]), of(points[2]), second);
    if (!start || !end) return;
    a = *start;
    b = *end;
    if (!is_far(a) && !is_far(b)) {
      const Definitions all{points, planes};
      from = refined(all, edge_cut(all, 0, 1, 1));
      to = refined(all, edge_cut(all, 0, 2, 1));
      is_line = Point2(from.near) != Point2(to.near);
    }
  }
  static bool is_far(const QPoint& p) {
    const Q limit = scaled(kCoordinateLimit, 0);
    return abs(p.x) > limit || abs(p.y) > limit || abs(p.z) > limit;
  }
  CommonLine line() const { return {points, planes, from, to}; }

  std::array<Point3, 6> points;
  std::array<Plane, 2> planes;
  DefinedPoint from, to;
  QPoint a, b;
  bool is_line = false;
};

TEST(LineParameters, OfTheLineThatTwoPlanesHaveInCommon) {
  Source s(6);
  long lines = 0;
  for (long k = 0; k < kTrials / 4; ++k) {
    const Trial trial(s);
    const LineOfPlanes of_planes(trial, s);
    if (!of_planes.is_line) continue;
    ++lines;
    const auto& [points, planes, from, to, a, b, is_line] = of_planes;
    const auto any = [&] {
      return s.below(3) == 0 ? of_planes.points[s.bits() % 6] : trial.point(s);
    };
    const Point3 p = any(), q = any(), r = any();
    const QPlane first(of(points[0]), of(points[1]), of(points[2]));
    const QPlane second(of(points[3]), of(points[4]), of(points[5]));
    const QPlane plane(of(p), of(q), of(r));
    const int mode = mode_of(s);
    const auto found = [&](const auto& ask) {
      return found_in_mode(mode, [&] { return static_cast<double>(ask(of_planes.line())); });
    };
    const Q x = of(p).x, y = of(p).y;
    ASSERT_EQ(found([&](const CommonLine& line) { return line.side(p); }),
              sgn(first.z(x, y) - second.z(x, y)))
        << k << hex(p);
    const Q turn_a = turn(of(p), of(q), a), turn_b = turn(of(p), of(q), b);
    if (turn_a != turn_b) {
      const double t =
          found([&](const CommonLine& line) { return line.crossing(Point2(p), Point2(q)); });
      ASSERT_TRUE(is_nearest(t, turn_a / (turn_a - turn_b))) << k << hex(p) << hex(q) << t;
    }
    const bool by_x = from.near.x != to.near.x;
    const Q start = by_x ? a.x : a.y, end = by_x ? b.x : b.y;
    if (start != end) {
      const double t = found([&](const CommonLine& line) { return line.at_point(Point2(p)); });
      ASSERT_TRUE(is_nearest(t, ((by_x ? x : y) - start) / (end - start))) << k << hex(p) << t;
    }
    if (plane.c == 0) continue;
    const int facing = sgn(plane.c);
    const Plane asked = facing > 0 ? Plane(p, q, r) : Plane(p, r, q);
    const Q at_a = plane.z(a.x, a.y) - a.z, at_b = plane.z(b.x, b.y) - b.z;
    ASSERT_EQ(found([&](const CommonLine& line) { return line.nearer_at_start(asked); }), sgn(at_a))
        << k;
    ASSERT_EQ(found([&](const CommonLine& line) { return line.nearer_at_end(asked); }), sgn(at_b))
        << k;
    if (sgn(at_a) * sgn(at_b) >= 0) continue;
    const double t = found([&](const CommonLine& line) { return line.meeting(asked); });
    ASSERT_TRUE(is_nearest(t, at_a / (at_a - at_b))) << k << hex(p) << hex(q) << hex(r) << t;
  }
  EXPECT_GT(lines, kTrials / 20);
}

TEST(LineParameters, TheMiddleStageLeavesNothingOrdinaryOfACommonLineToTheExactOne) {
  Source s(7);
  reset_predicate_counts();
  for (int k = 0; k < 3000; ++k) {
    const auto point = [&] {
      const double x = s.unit(), y = s.unit(), z = s.unit();
      return Point3(x, y, z);
    };
    std::array<Point3, 6> points;
    for (Point3& p : points) p = point();
    const std::array planes{Plane(points[0], points[1], points[2]),
                            Plane(points[3], points[4], points[5])};
    const Definitions all{points, planes};
    const DefinedPoint from = refined(all, edge_cut(all, 0, 1, 1)),
                       to = refined(all, edge_cut(all, 0, 2, 1));
    const CommonLine line(points, planes, from, to);
    const Point3 p = point(), q = point(), r = point();
    line.crossing(Point2(p), Point2(q));
    line.meeting(Plane(p, q, r));
  }
  const auto counts = predicate_counts();
  EXPECT_EQ(counts[static_cast<std::size_t>(Predicate::line_parameter)].exact, 0u);
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
