// What a filtered predicate costs against the naive determinant and against CGAL, on the same
// input in the same run: the methods take turns, and what is printed is the median over the
// turns of the ratio of their times. Then how often each stage decides.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string_view>
#include <vector>

#include "hidden/defined_point.h"
#include "hidden/depth_order.h"
#include "hidden/orientation.h"
#include "hidden/pixel_centre.h"
#include "hidden/plane.h"
#include "hidden/predicate_counts.h"
#include "tests/bench/side_by_side.h"

namespace {

using namespace displayfile;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::size_t kTuples = 1 << 12;  // in the caches, so that arithmetic is what is timed
constexpr int kPasses = 8;
constexpr int kTurns = 301;

std::vector<Point3> random_points(std::size_t count) {
  std::mt19937_64 random(1);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Point3> points(count);
  for (Point3& p : points) {
    p.x = unit();
    p.y = unit();
    p.z = unit();
  }
  return points;
}

/// A method over all tuples, one sign after the other, and not on several tuples at once: a
/// sort asks for one sign at a time.
template <class Sign>
void add_signs(const Sign& sign_of_tuple, long& sum) {
  for (int pass = 0; pass < kPasses; ++pass) {
    for (std::size_t k = 0; k < kTuples; ++k) {
      int sign = sign_of_tuple(k);
      asm volatile("" : "+r"(sign));
      sum += sign;
    }
  }
}

/// The second method's time over the first's.
template <class First, class Second>
double ratio(const First& first, const Second& second) {
  long sum = 0;
  const bench::Spread times = bench::times_faster(
      kTurns, [&] { add_signs(first, sum); }, [&] { add_signs(second, sum); });
  asm volatile("" : : "r"(sum));
  return times.median;
}

void line(std::string_view what, double measured, std::string_view against) {
  fmt::print("  {:<46} {:5.2f}  {}\n", what, measured, against);
}

int naive_side(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const double wx = d.x - a.x, wy = d.y - a.y, wz = d.z - a.z;
  return sign_of(wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz) + wz * (ux * vy - uy * vx));
}

void print_counts(std::string_view title, double calls) {
  fmt::print("{}\n", title);
  const PredicateCounts counts = predicate_counts();
  for (std::size_t k = 0; k < kPredicates; ++k) {
    if (counts[k].exact + counts[k].by_definition == 0) continue;
    fmt::print("  {:<16} of {:.0f} calls: {} by definition, {} exact ({:.4f} %)\n",
               name_of(static_cast<Predicate>(k)), calls, counts[k].by_definition, counts[k].exact,
               100.0 * static_cast<double>(counts[k].exact) / calls);
  }
}

}  // namespace

int main() {
  const std::vector<Point3> p = random_points(4 * kTuples);
  std::vector<Kernel::Point_2> flat;
  std::vector<Kernel::Point_3> solid;
  for (const Point3& v : p) {
    flat.emplace_back(v.x, v.y);
    solid.emplace_back(v.x, v.y, v.z);
  }
  std::vector<Point2> q;
  for (const Point3& v : p) q.emplace_back(v.x, v.y);
  std::vector<Plane> planes;
  for (std::size_t k = 0; k < kTuples; ++k)
    planes.emplace_back(p[4 * k], p[4 * k + 1], p[4 * k + 2]);
  const Definitions all{p, planes};
  std::vector<DefinedPoint> cuts;
  for (std::size_t k = 0; k < kTuples; ++k) {
    const auto i = static_cast<std::uint32_t>(k);
    const auto other = static_cast<std::uint32_t>((k + 1) % kTuples);
    cuts.push_back(k % 2 == 0
                       ? edge_cut(all, 4 * i, 4 * i + 3, other)
                       : plane_cut(all, i, other, static_cast<std::uint32_t>((k + 2) % kTuples)));
  }

  const auto naive_2 = [&](std::size_t k) {
    const Point2 &a = q[4 * k], &b = q[4 * k + 1], &c = q[4 * k + 2];
    return sign_of((a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x));
  };
  const auto ours_2 = [&](std::size_t k) {
    return orientation(q[4 * k], q[4 * k + 1], q[4 * k + 2]);
  };
  const auto cgal_2 = [&](std::size_t k) {
    return static_cast<int>(CGAL::orientation(flat[4 * k], flat[4 * k + 1], flat[4 * k + 2]));
  };
  const auto naive_3 = [&](std::size_t k) {
    return naive_side(p[4 * k], p[4 * k + 1], p[4 * k + 2], p[4 * k + 3]);
  };
  const auto ours_3 = [&](std::size_t k) {
    return orientation(p[4 * k], p[4 * k + 1], p[4 * k + 2], p[4 * k + 3]);
  };
  const auto cgal_3 = [&](std::size_t k) {
    return static_cast<int>(
        CGAL::orientation(solid[4 * k], solid[4 * k + 1], solid[4 * k + 2], solid[4 * k + 3]));
  };
  const auto ours_plane = [&](std::size_t k) { return side_of_plane(p[4 * k + 3], planes[k]); };
  const auto naive_plane = [&](std::size_t k) {
    const Point3 &n = planes[k].normal, &v = p[4 * k + 3], &o = planes[k].p;
    return sign_of(n.x * (v.x - o.x) + n.y * (v.y - o.y) + n.z * (v.z - o.z));
  };
  const auto ours_defined = [&](std::size_t k) {
    return side_of_plane(all, cuts[k], planes[(k + 5) % kTuples]);
  };
  const auto naive_defined = [&](std::size_t k) {
    const Plane& plane = planes[(k + 5) % kTuples];
    const Point3 &n = plane.normal, &v = cuts[k].near, &o = plane.p;
    return sign_of(n.x * (v.x - o.x) + n.y * (v.y - o.y) + n.z * (v.z - o.z));
  };
  const PixelCentre centre(300, 700, {1000, 1000});
  const auto ours_crossing = [&](std::size_t k) {
    return crossing(q[4 * k], q[4 * k + 1], centre);
  };
  const auto naive_crossing = [&](std::size_t k) {
    const Point2 &a = q[4 * k], &b = q[4 * k + 1];
    const double d = (a.x - centre.x) * (b.y - a.y) - (a.y - centre.y) * (b.x - a.x);
    return a.y < b.y ? sign_of(d) : -sign_of(d);
  };
  const auto ours_depth = [&](std::size_t k) {
    return depth_order(planes[k], planes[(k + 1) % kTuples], centre);
  };
  const auto naive_depth = [&](std::size_t k) {
    const auto z = [&](const Plane& s) {
      return s.p.z -
             (s.normal.x * (centre.x - s.p.x) + s.normal.y * (centre.y - s.p.y)) / s.normal.z;
    };
    return sign_of(z(planes[k]) - z(planes[(k + 1) % kTuples]));
  };

  reset_predicate_counts();
  fmt::print("time of the filtered predicate, random input (ratio; at most 1.5 of the naive)\n");
  line("orientation, three points of the projection", ratio(naive_2, ours_2), "naive determinant");
  line("orientation, four points", ratio(naive_3, ours_3), "naive determinant");
  line("point against a plane", ratio(naive_3, ours_plane), "naive determinant");
  line("point against a plane", ratio(naive_plane, ours_plane), "rounded normal kept in the plane");
  line("defined point against a plane", ratio(naive_3, ours_defined), "naive determinant");
  line("defined point against a plane", ratio(naive_defined, ours_defined),
       "rounded point, rounded normal");
  line("pixel centre against an edge", ratio(naive_crossing, ours_crossing), "naive determinant");
  line("two planes at a pixel centre", ratio(naive_depth, ours_depth), "rounded depths");
  fmt::print("against CGAL's exact-predicates kernel (at most 1 is not slower)\n");
  line("orientation, three points of the projection", ratio(cgal_2, ours_2), "CGAL");
  line("orientation, four points", ratio(cgal_3, ours_3), "CGAL");
  line("point against a plane", ratio(cgal_3, ours_plane), "CGAL");
  print_counts("stages, all of the above", 1.0 * kPasses * kTurns * kTuples);
}
