// The cost of a filtered predicate against the naive determinant, against rounded coefficients and
// against CGAL, on the same input in the same run: the methods take turns. Then how often the exact
// stage decides, and its cost alone.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <random>
#include <string_view>
#include <vector>

#include "clip/geometry/unit.h"
#include "hidden/exact/defined_point.h"
#include "hidden/exact/depth_order.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/predicate_counts.h"
#include "tests/bench/benchmark.h"

namespace displayfile::bench {

const char* const kAbout = "Filtered predicates, in turn with others";

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::size_t kTuples = 1 << 12;  // in the caches, so that arithmetic is timed
constexpr int kPasses = 8;
constexpr int kTurns = 301;
constexpr int kTurnsOfExact = 9;  // slow, and so less often interrupted in proportion

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

/// A method over all tuples, one sign after the other, not several tuples at once: a sort needs one
/// sign at a time.
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
void print(const char* table, const char* what, const auto& first, const auto& second,
           int turns = kTurns) {
  long sum = 0;
  const Spread times = times_faster(
      turns, [&] { add_signs(first, sum); }, [&] { add_signs(second, sum); });
  asm volatile("" : : "r"(sum));
  print_row({{"table", table}, {"predicate", what}, {"time", figure(times.median)}});
}

int naive_turn(const Point2& a, const Point2& b, const Point2& c) {
  return sign_of((a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x));
}

int naive_side(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const double wx = d.x - a.x, wy = d.y - a.y, wz = d.z - a.z;
  return sign_of(wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz) + wz * (ux * vy - uy * vx));
}

void print_counts() {
  const PredicateCounts counts = predicate_counts();
  for (std::size_t k = 0; k < kPredicates; ++k) {
    print_row({{"table", "asked of the exact stage, in all of the above"},
               {"predicate", name_of(static_cast<Predicate>(k))},
               {"asked", counts[k].exact},
               {"zero by definition", counts[k].by_definition}});
  }
}

/// The input, and plain pointers to it for the methods.
struct Input {
  std::vector<Point3> points = random_points(4 * kTuples);
  std::vector<Point2> flat_points;
  std::vector<Kernel::Point_2> cgal_flat_points;
  std::vector<Kernel::Point_3> cgal_points;
  std::vector<Plane> planes;
  std::vector<DefinedPoint> cuts;

  Input() {
    for (const Point3& p : points) {
      flat_points.emplace_back(p.x, p.y);
      cgal_flat_points.emplace_back(p.x, p.y);
      cgal_points.emplace_back(p.x, p.y, p.z);
    }
    for (std::size_t k = 0; k < points.size(); k += 4) {
      planes.emplace_back(points[k], points[k + 1], points[k + 2]);
    }
    constexpr auto kCount = static_cast<std::uint32_t>(kTuples);
    for (std::uint32_t k = 0; k < kCount; ++k) {
      const std::uint32_t next = (k + 1) % kCount, after = (k + 2) % kCount;
      cuts.push_back(k % 2 == 0 ? edge_cut(definitions(), 4 * k, 4 * k + 3, next)
                                : plane_cut(definitions(), k, next, after));
    }
  }
  Definitions definitions() const { return {points, planes}; }
};

int rounded_side(const Point3& v, const Plane& plane) {
  const Point3 &n = plane.normal, &o = plane.p;
  return sign_of(n.x * (v.x - o.x) + n.y * (v.y - o.y) + n.z * (v.z - o.z));
}

int naive_crossing(const Point2& a, const Point2& b, const PixelCentre& centre) {
  const double d = (a.x - centre.x) * (b.y - a.y) - (a.y - centre.y) * (b.x - a.x);
  return a.y < b.y ? sign_of(d) : -sign_of(d);
}

/// (za - zb) Ca Cb at a position of the projection, from the six points.
int naive_depth_order(const Point3* a, const Point3* b, const PixelCentre& at) {
  struct Value {
    double slope, c;
  };
  const auto value = [&](const Point3* p) {
    const Point3 u = p[1] - p[0], v = p[2] - p[0];
    return Value{(u.y * v.z - u.z * v.y) * (at.x - p->x) + (u.z * v.x - u.x * v.z) * (at.y - p->y),
                 u.x * v.y - u.y * v.x};
  };
  const Value of_a = value(a), of_b = value(b);
  return sign_of((a->z - b->z) * of_a.c * of_b.c - of_a.slope * of_b.c + of_b.slope * of_a.c) *
         sign_of(of_a.c) * sign_of(of_b.c);
}

int rounded_depth_order(const Plane& a, const Plane& b, const PixelCentre& at) {
  const auto z = [&](const Plane& s) {
    return s.p.z - (s.normal.x * (at.x - s.p.x) + s.normal.y * (at.y - s.p.y)) / s.normal.z;
  };
  return sign_of(z(a) - z(b));
}

}  // namespace

void run(const Options&) {
  const Input input;
  const Definitions all = input.definitions();
  const Point3* const p = input.points.data();
  const Point2* const q = input.flat_points.data();
  const Kernel::Point_2* const flat = input.cgal_flat_points.data();
  const Kernel::Point_3* const solid = input.cgal_points.data();
  const Plane* const planes = input.planes.data();
  const DefinedPoint* const cuts = input.cuts.data();
  const PixelCentre centre(300, 700, {1000, 1000});
  const auto other = [](std::size_t k) { return (k + 5) % kTuples; };

  const auto naive_2 = [=](std::size_t k) {
    return naive_turn(q[4 * k], q[4 * k + 1], q[4 * k + 2]);
  };
  const auto ours_2 = [=](std::size_t k) {
    return orientation(q[4 * k], q[4 * k + 1], q[4 * k + 2]);
  };
  const auto cgal_2 = [=](std::size_t k) {
    return static_cast<int>(CGAL::orientation(flat[4 * k], flat[4 * k + 1], flat[4 * k + 2]));
  };
  const auto naive_3 = [=](std::size_t k) {
    return naive_side(p[4 * k], p[4 * k + 1], p[4 * k + 2], p[4 * k + 3]);
  };
  const auto ours_3 = [=](std::size_t k) {
    return orientation(p[4 * k], p[4 * k + 1], p[4 * k + 2], p[4 * k + 3]);
  };
  const auto cgal_3 = [=](std::size_t k) {
    return static_cast<int>(
        CGAL::orientation(solid[4 * k], solid[4 * k + 1], solid[4 * k + 2], solid[4 * k + 3]));
  };
  const auto ours_plane = [=](std::size_t k) { return side_of_plane(p[4 * k + 3], planes[k]); };
  const auto rounded_plane = [=](std::size_t k) { return rounded_side(p[4 * k + 3], planes[k]); };
  const auto ours_defined = [=](std::size_t k) {
    return side_of_plane(all, cuts[k], planes[other(k)]);
  };
  const auto rounded_defined = [=](std::size_t k) {
    return rounded_side(cuts[k].near, planes[other(k)]);
  };
  const auto ours_crossing = [=](std::size_t k) {
    return crossing(q[4 * k], q[4 * k + 1], centre);
  };
  const auto naive_edge = [=](std::size_t k) {
    return naive_crossing(q[4 * k], q[4 * k + 1], centre);
  };
  const auto ours_depth = [=](std::size_t k) {
    return depth_order(planes[k], planes[other(k)], centre);
  };
  const auto naive_depth = [=](std::size_t k) {
    return naive_depth_order(p + 4 * k, p + 4 * other(k), centre);
  };
  const auto rounded_depth = [=](std::size_t k) {
    return rounded_depth_order(planes[k], planes[other(k)], centre);
  };

  const auto exact_2 = [=](std::size_t k) {
    return exact_orientation(q[4 * k], q[4 * k + 1], q[4 * k + 2]);
  };
  const auto exact_3 = [=](std::size_t k) {
    return exact_orientation(p[4 * k], p[4 * k + 1], p[4 * k + 2], p[4 * k + 3]);
  };
  const auto exact_defined = [=](std::size_t k) {
    return exact_side_of_plane(all, cuts[k], planes[other(k)]);
  };
  const auto exact_depth = [=](std::size_t k) {
    return exact_depth_order(planes[k], planes[other(k)], centre);
  };

  reset_predicate_counts();
  constexpr const char *kTurn = "orientation, three points of the projection",
                       *kFour = "orientation, four points",
                       *kStored = "stored point against a plane",
                       *kDefined = "defined point against a plane",
                       *kDepth = "two planes at a pixel centre";
  const char* table = "against the naive determinant of the points (the aim: at most 1.5)";
  print(table, kTurn, naive_2, ours_2);
  print(table, kFour, naive_3, ours_3);
  print(table, kStored, naive_3, ours_plane);
  print(table, kDefined, naive_3, ours_defined);
  print(table, "pixel centre against an edge", naive_edge, ours_crossing);
  print(table, kDepth, naive_depth, ours_depth);
  table = "against rounded coefficients kept in the plane (what roundoff does)";
  print(table, kStored, rounded_plane, ours_plane);
  print(table, kDefined, rounded_defined, ours_defined);
  print(table, kDepth, rounded_depth, ours_depth);
  table = "against CGAL's exact-predicates kernel (the aim: at most 1)";
  print(table, kTurn, cgal_2, ours_2);
  print(table, kFour, cgal_3, ours_3);
  print(table, kStored, cgal_3, ours_plane);
  print_counts();
  table = "the exact stage alone, against the filtered predicate";
  print(table, kTurn, ours_2, exact_2, kTurnsOfExact);
  print(table, kFour, ours_3, exact_3, kTurnsOfExact);
  print(table, kDefined, ours_defined, exact_defined, kTurnsOfExact);
  print(table, kDepth, ours_depth, exact_depth, kTurnsOfExact);
}

}  // namespace displayfile::bench
