// libFuzzer target: the predicates of points give the sign that rationals give, for any doubles of
// the range that they are stated for (hidden/exact/predicates.md).

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "hidden/exact/orientation.h"
#include "hidden/exact/plane.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/rational_points.h"

namespace {

using namespace displayfile;
using test::QPoint;

constexpr double kLargest = 1e100;

/// Any double within the range, or a combination of the points before that is nearly degenerate.
Point3 point(fuzz::FuzzInput& input, const std::vector<Point3>& before) {
  const int kind = input.below(4);
  if (kind == 0 || before.size() < 2) {
    Point3 p(input.any_double(), input.any_double(), input.any_double());
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(p[axis]) <= kLargest)) p[axis] = input.near_grid(16);
    }
    return p;
  }
  if (kind == 1) return input.point_near_grid(16);
  const Point3& a = before[static_cast<std::size_t>(input.byte()) % before.size()];
  const Point3& b = before[static_cast<std::size_t>(input.byte()) % before.size()];
  const double t = static_cast<double>(input.byte()) / 64.0 - 2.0;
  Point3 p = a + t * (b - a);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(std::abs(p[axis]) <= kLargest)) p[axis] = a[axis];
  }
  return p;
}

void check(const char* predicate, int found, int right) {
  if (found == right) return;
  std::fprintf(stderr, "%s: %d where rationals say %d\n", predicate, found, right);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::FuzzInput input({data, size});
  std::vector<Point3> p;
  for (int count = 4 + input.below(5); count > 0; --count) p.push_back(point(input, p));

  test::Shift shift;
  for (const Point3& v : p) shift.include(v);
  std::vector<QPoint> q;
  for (const Point3& v : p) q.push_back(test::exact(v, shift.value()));

  const Plane plane(p[0], p[1], p[2]);
  check("orientation", orientation(p[0], p[1], p[2]), sgn(test::turn(q[0], q[1], q[2])));
  check("facing of a plane", facing(plane), sgn(test::turn(q[0], q[1], q[2])));
  const int side = sgn(test::QPlane(q[0], q[1], q[2]).at(q[3]));
  check("orientation of four", orientation(p[0], p[1], p[2], p[3]), side);
  check("side of a plane", side_of_plane(p[3], plane), side);
  return 0;
}
