#include "hidden/exact/precision_policies.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "clip/base/error.h"
#include "clip/surfaces.h"
#include "tests/predicate_inputs.h"
#include "tests/predicate_truth.h"

namespace displayfile {
namespace {

using namespace test;

TEST(Precision, IsReadFromTheCommandLine) {
  EXPECT_TRUE(precision("exact").exact);
  EXPECT_FALSE(precision("roundoff").exact);
  EXPECT_EQ(precision("roundoff").roundoff, Precision::kUsualRoundoff);
  EXPECT_EQ(precision("roundoff=1e-3").roundoff, 1e-3);
  EXPECT_EQ(precision("roundoff=0").roundoff, 0.0);
  for (const char* wrong : {"", "exactly", "roundoff=", "roundoff=x", "roundoff=-1", "roundoff=1",
                            "roundoff=nan", "roundoff=1e-3x", "Exact"}) {
    EXPECT_THROW(precision(wrong), Error) << wrong;
  }
}

TEST(Precision, ItsRoundoffCountsOnlyWhereItIsUsed) {
  EXPECT_EQ(precision("exact"), (Precision{.exact = true, .roundoff = 0.5}));
  EXPECT_EQ(precision("roundoff=0.5"), (Precision{.exact = false, .roundoff = 0.5}));
  EXPECT_NE(precision("roundoff=0.5"), precision("roundoff=0.25"));
  EXPECT_NE(precision("roundoff"), precision("exact"));
}

TEST(Precision, SignofIsTheTextbooks) {
  const Roundoff roundoff({}, 0.5);
  EXPECT_EQ(roundoff.signof(0.5), 0);
  EXPECT_EQ(roundoff.signof(-0.5), 0);
  EXPECT_EQ(roundoff.signof(std::nextafter(0.5, 1.0)), 1);
  EXPECT_EQ(roundoff.signof(std::nextafter(-0.5, -1.0)), -1);
  EXPECT_EQ(roundoff.signof(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(Precision, RoundoffIsALengthRelativeToTheScene) {
  const std::vector<Point3> points = {{0, 0, 0}, {200, 0, 0}, {0, 100, 0}, {0, 0, 1.5}};
  const std::vector<Plane> planes = {Plane(points[0], points[1], points[2])};
  const Definitions all{points, planes};
  EXPECT_EQ(Roundoff::relative(all, 0.01).roundoff(), 2.0);
  EXPECT_EQ(Roundoff::relative(all, 0.01).side(points[3], 0), 0);
  EXPECT_EQ(Roundoff::relative(all, 0.001).side(points[3], 0), 1);
}

/// A convex piece of a polygon: its vertices, and for each the line of the side that starts there.
template <class Policy>
struct Piece {
  std::vector<typename Policy::Vertex> vertices;
  std::vector<SideLine> sides;
};

/// The part of the piece on one side of a plane: the clipping step that COMPARE-POLYS makes
/// twice, written once over the policy.
template <class Policy>
Piece<Policy> part(const Policy& policy, const Piece<Policy>& piece, std::uint32_t own,
                   std::uint32_t plane, int wanted) {
  Piece<Policy> kept;
  const auto add = [&](const typename Policy::Vertex& v, const SideLine& side) {
    kept.vertices.push_back(v);
    kept.sides.push_back(side);
  };
  for (std::size_t k = 0; k < piece.vertices.size(); ++k) {
    const auto &from = piece.vertices[k], &to = piece.vertices[(k + 1) % piece.vertices.size()];
    const int at_from = policy.side(from, plane), at_to = policy.side(to, plane);
    if (at_from == wanted || at_from == 0) add(from, piece.sides[k]);
    if (at_from * at_to >= 0) continue;
    const bool leaves = at_from == wanted;
    add(policy.cut(from, to, piece.sides[k], own, plane),
        leaves ? SideLine::cut_by(plane) : piece.sides[k]);
  }
  return kept;
}

struct Scene {
  std::vector<Point3> points = {{0, 0, 0}, {1, 0.125, 0.5}, {0.25, 1, 0.25}};
  std::vector<Plane> planes = {Plane(points[0], points[1], points[2])};
  Definitions all() const { return {points, planes}; }
};
template <class Policy>
Piece<Policy> triangle(const Policy& policy) {
  return {{policy.vertex(0, 0), policy.vertex(1, 0), policy.vertex(2, 0)},
          {SideLine::edge(0, 1), SideLine::edge(1, 2), SideLine::edge(2, 0)}};
}

/// How often, over all pieces of pieces that a number of planes cut a triangle into, a vertex
/// is on the wrong side of a plane that bounds its piece.
template <class Policy>
int misplaced(const Policy& policy, std::uint32_t planes) {
  std::vector<Piece<Policy>> pieces = {triangle(policy)};
  int wrong = 0;
  for (std::uint32_t plane = 1; plane < planes; ++plane) {
    std::vector<Piece<Policy>> next;
    for (const Piece<Policy>& piece : pieces) {
      for (const int side : {1, -1}) {
        Piece<Policy> kept = part(policy, piece, 0, plane, side);
        if (kept.vertices.size() < 3) continue;
        for (const auto& v : kept.vertices) wrong += policy.side(v, plane) == -side;
        next.push_back(std::move(kept));
      }
    }
    pieces = std::move(next);
  }
  return wrong;
}

TEST(Precision, PiecesOfPiecesStayOnTheirSideInExact) {
  Scene scene;
  Source s(5);
  // Planes through one point of the triangle, and nearly parallel ones: cases that rounding loses.
  const Point3 centre = {0.4375, 0.375, 0.265625};
  while (scene.planes.size() < 12) {
    const auto at = [&] {
      return centre + 1e-3 * Point3(s.unit() - 0.5, s.unit() - 0.5, s.unit());
    };
    const Point3 p = at(), q = at();
    scene.planes.emplace_back(centre, p, q);
  }
  const Exact exact(scene.all());
  const auto planes = static_cast<std::uint32_t>(scene.planes.size());
  EXPECT_EQ(misplaced(exact, planes), 0);
  EXPECT_GT(misplaced(Roundoff(scene.all(), 0.0), planes), 0) << "rounding is not put to the test";
}

TEST(Precision, BothPoliciesCutATriangleAlike) {
  Scene scene;
  scene.planes.emplace_back(Point3(0.5, 0, 0), Point3(0.5, 1, 0), Point3(0.5, 0, 1));
  scene.planes.emplace_back(Point3(0, 0.5, 0), Point3(1, 0.5, 0), Point3(0, 0.5, 1));
  const Exact exact(scene.all());
  const Roundoff roundoff(scene.all(), 1e-12);
  const auto by_exact = part(exact, part(exact, triangle(exact), 0, 1, 1), 0, 2, 1);
  const auto by_roundoff = part(roundoff, part(roundoff, triangle(roundoff), 0, 1, 1), 0, 2, 1);
  ASSERT_EQ(by_exact.vertices.size(), by_roundoff.vertices.size());
  for (std::size_t k = 0; k < by_exact.vertices.size(); ++k) {
    const Point3 off =
        exact.coordinates(by_exact.vertices[k]) - roundoff.coordinates(by_roundoff.vertices[k]);
    EXPECT_LT(std::abs(off.x) + std::abs(off.y) + std::abs(off.z), 1e-15);
  }
}

TEST(Precision, VerticesOffTheSupportPlaneAreLifted) {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-9}};
  const std::vector<Plane> planes = {Plane(points[0], points[1], points[2])};
  const Definitions all{points, planes};
  const Exact lifting(all);
  EXPECT_EQ(lifting.side(lifting.vertex(3, 0), 0), 0);
  EXPECT_EQ(lifting.coordinates(lifting.vertex(3, 0)), Point3(1, 1, 0));
}

TEST(Precision, BeforeViewingTheyAreLiftedAlongTheAxisThatThePlaneFaces) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto turned = [&](const Point3& p) {
      Point3 q;
      for (int i = 0; i < 3; ++i) q[(i + axis + 1) % 3] = p[i];
      return q;
    };
    // The last two are off the plane z = x / 2, before turning; z is the axis that it faces.
    std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0}, {3, 1, 2}, {5, 1, 2}};
    for (Point3& p : points) p = turned(p);
    const std::vector<Plane> planes = {
        Plane(points[0], points[1], points[2]),
        Plane(turned({4, 0, 0}), turned({4, 1, 0}), turned({4, 0, 1}))};
    const Definitions all{points, planes};
    const Exact lifting(all, Exact::Lift::along_facing_axis);
    const DefinedPoint a = lifting.vertex(3, 0), b = lifting.vertex(4, 0);
    EXPECT_EQ(facing_axis(planes[0]), axis);
    EXPECT_EQ(lifting.coordinates(a), turned({3, 1, 1.5}));
    EXPECT_EQ(lifting.side(a, 0), 0);
    const DefinedPoint cut = lifting.cut(a, b, SideLine::edge(3, 4), 0, 1);
    EXPECT_EQ(lifting.coordinates(cut), turned({4, 1, 2}));
    EXPECT_EQ(lifting.side(cut, 0), 0);
    EXPECT_EQ(lifting.side(cut, 1), 0);
  }
}

TEST(Precision, ThePlaneOfASliverFacesAnAxisToo) {
  for (int i = 1; i <= 200; ++i) {
    // Collinear up to rounding, so that the normal in doubles is nothing but its error.
    const Point3 p(0.0), q(0.1 * i, 0.7 / i, 1.0 / 3), r = q * (1.0 / 7);
    const Plane plane(p, q, r);
    const QPlane exactly({p.x, p.y, p.z}, {q.x, q.y, q.z}, {r.x, r.y, r.z});
    if (exactly.a == 0 && exactly.b == 0 && exactly.c == 0) continue;  // no plane at all
    const int axis = facing_axis(plane);
    Point3 step(0.0);
    step[axis] = 1.0;
    EXPECT_NE(side_of_plane(step, plane), 0) << i << ", axis " << axis;
  }
}

}  // namespace
}  // namespace displayfile
