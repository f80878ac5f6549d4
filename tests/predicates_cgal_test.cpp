// Orientation in two and three dimensions against CGAL's exact kernel, on the input of
// tests/predicates_test.cpp.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "hidden/exact/orientation.h"
#include "hidden/exact/plane.h"
#include "tests/predicate_inputs.h"

namespace displayfile {
namespace {

using namespace test;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_2 in_the_plane(const Point3& p) { return {p.x, p.y}; }
Kernel::Point_3 in_space(const Point3& p) { return {p.x, p.y, p.z}; }

/// Four points at random, or of one plane, the first three of one line; nudged by a few ulps.
std::array<Point3, 4> four_points(Source& s, bool near_zero) {
  std::array<Point3, 4> p;
  if (!near_zero) {
    const Style style(s, true);
    for (Point3& v : p) v = style.point(s);
    return p;
  }
  const Grid grid(s);
  const Step g = step(s, 100), u = step(s, step_size(s)), v = step(s, step_size(s));
  const bool in_line = s.below(2) == 0;
  for (std::size_t k = 0; k < 4; ++k) {
    p[k] = grid.place(s, g + factor(s) * u + (in_line && k < 3 ? 0 : factor(s)) * v);
  }
  return p;
}

TEST(PredicatesAndCgal, OrientationsAgree) {
  for (const bool near_zero : {false, true}) {
    Source s(near_zero ? 4 : 3);
    for (long k = 0; k < trials(); ++k) {
      const std::array<Point3, 4> p = four_points(s, near_zero);
      const int mode = kModes[static_cast<std::size_t>(k % 4)];
      const int turn =
          CGAL::orientation(in_the_plane(p[0]), in_the_plane(p[1]), in_the_plane(p[2]));
      const int side =
          CGAL::orientation(in_space(p[0]), in_space(p[1]), in_space(p[2]), in_space(p[3]));
      ASSERT_EQ(in_mode(mode, [&] { return orientation(p[0], p[1], p[2]); }), turn)
          << hex(p[0]) << hex(p[1]) << hex(p[2]);
      ASSERT_EQ(in_mode(mode, [&] { return orientation(p[0], p[1], p[2], p[3]); }), side)
          << hex(p[0]) << hex(p[1]) << hex(p[2]) << hex(p[3]);
      ASSERT_EQ(in_mode(mode, [&] { return side_of_plane(p[3], Plane(p[0], p[1], p[2])); }), side);
    }
  }
}

}  // namespace
}  // namespace displayfile
