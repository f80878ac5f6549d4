// Which polygons lie in the plane of another: against the truth's own search, which compares each
// with all.

#include "hidden/touching/touching_planes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <glm/mat4x3.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "clip/base/work_budget.h"
#include "clip/surfaces.h"
#include "hidden/exact/predicate_counts.h"
#include "interp/truth/true_planes.h"
#include "programs/scenes/scene.h"
#include "tests/from_environment.h"
#include "tests/retained_truth.h"
#include "tests/scenes_that_clip.h"
#include "tests/slower.h"
#include "tests/touching_scenes.h"

namespace displayfile {
namespace {

using test::any_matrix;
using test::decimal;
using test::Retained;
using test::Source;

constexpr Touching kOff{Touching::Kind::off};
Touching within(double length) { return {Touching::Kind::length, length}; }

std::uint64_t scenes() {
  return static_cast<std::uint64_t>(
      test::from_environment("DISPLAYFILE_TOUCHING_SCENES", 60 / test::kSlower));
}

double reach_of(const RetainedScene& scene, const Touching& touching) {
  double largest = 0.0;
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    for (const Point3& p : scene.entered_points(i)) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  return entered_reach(touching, largest);
}

TouchingPlanes planes_of(const RetainedScene& scene, const Touching& touching) {
  const auto polygon = [&](std::uint32_t i) {
    return EnteredPolygon{scene.entered_points(i), &scene.modelling_matrix(i)};
  };
  return TouchingPlanes(scene.size(), polygon, reach_of(scene, touching));
}

/// Each plane that polygons share has its own polygon first, and each polygon that touches once, in
/// order of entry among equal areas.
void expect_members(const TouchingPlanes& planes, std::uint32_t polygons) {
  std::vector<std::uint32_t> times(polygons, 0);
  for (std::size_t k = 0; k < planes.shared_planes(); ++k) {
    const auto members = planes.members(k);
    ASSERT_GE(members.size(), 2u);
    ASSERT_EQ(planes.plane_of(members[0]), members[0]);
    for (const std::uint32_t i : members) {
      ASSERT_EQ(planes.plane_of(i), members[0]);
      ++times[i];
    }
  }
  std::size_t touching = 0;
  for (std::uint32_t i = 0; i < polygons; ++i) {
    if (planes.plane_of(i) == i) continue;
    ++touching;
    ASSERT_EQ(times[i], 1u);
  }
  ASSERT_EQ(planes.touching(), touching);
}

/// The same answer as the truth's. Returns the number of polygons that touch another.
std::size_t expect_truth(const RetainedScene& scene, const Touching& touching) {
  const TruePlanes expected(scene, touching);
  const TouchingPlanes found = planes_of(scene, touching);
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    EXPECT_EQ(found.plane_of(i), expected.plane_of(i)) << "polygon " << i;
    EXPECT_EQ(found.has_plane(i), expected.own_plane(i).has_value()) << "polygon " << i;
    if (testing::Test::HasFailure()) return 0;
  }
  EXPECT_EQ(found.touching(), expected.touching());
  expect_members(found, scene.size());
  return found.touching();
}

/// Calls enter(source, system) for scenes from many seeds and compares each with the truth. Returns
/// the number of polygons that touch another in all of them.
template <class Enter>
std::size_t expect_truth_of(const Touching& touching, Enter&& enter) {
  std::size_t touch = 0;
  for (std::uint64_t seed = 0; seed < scenes(); ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(seed);
    Retained retained;
    retained.system.open_segment(1);
    enter(s, retained.system);
    retained.system.close_segment();
    touch += expect_truth(retained.scene, touching);
    if (testing::Test::HasFailure()) break;
  }
  return touch;
}

using Triangles = std::vector<std::array<Point3, 3>>;

TouchingPlanes planes_of(const Triangles& triangles, double reach,
                         const glm::dmat4x3* matrix = nullptr) {
  return TouchingPlanes(
      static_cast<std::uint32_t>(triangles.size()),
      [&](std::uint32_t i) {
        return EnteredPolygon{triangles[i], matrix};
      },
      reach);
}

/// Three rotations and a translation, as parts are placed, and now and then a scale.
void place_anywhere(Source& s, GraphicsSystem& g) {
  g.create_transformation_3();
  if (s.below(5) == 0) {
    g.scale_3(decimal(s, 0.1, 3), decimal(s, -3, 3), decimal(s, 0.1, 3));
  }
  test::turn_and_move(s, g);
}

TEST(TouchingPlanes, OfPolygonsOnCoarseGrids) {
  for (const Touching& touching : {Touching{}, kOff, within(0.3), within(0.05), within(1e-12)}) {
    const std::size_t touch = expect_truth_of(touching, [](Source& s, GraphicsSystem& g) {
      for (int n = s.between(10, 80); n > 0; --n) {
        if (s.below(20) == 0) place_anywhere(s, g);
        if (s.below(20) == 0) g.create_transformation_3();
        g.polygon_abs_3(s.below(2) == 0 ? test::triangle(s) : test::flat(s));
      }
    });
    EXPECT_GT(touch, 0u);
  }
}

TEST(TouchingPlanes, OfWindowsInRoofsAndRugsOnFloors) {
  const std::size_t touch = expect_truth_of({}, [](Source& s, GraphicsSystem& g) {
    for (int n = s.between(4, 20); n > 0; --n) {
      if (s.below(2) == 0) place_anywhere(s, g);
      s.below(2) == 0 ? test::enter_rug_on_floor(s, g) : test::enter_window_in_roof(s, g);
    }
  });
  EXPECT_GE(touch, scenes() * 4);
}

/// A polygon of `sides` sides in z = 0.
std::vector<Point3> any_flat(Source& s, double size, int sides) {
  std::vector<Point3> polygon;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + 0.7 * s.unit()) / sides;
    polygon.emplace_back(size * std::cos(angle), size * std::sin(angle), 0.0);
  }
  return polygon;
}

/// Sheets that are apart by fractions and multiples of the reach, entered in any order, in one call
/// or several, of large, small, tiny and narrow polygons.
void enter_sheets(Source& s, GraphicsSystem& g, double reach, bool placed) {
  constexpr std::array<double, 8> kApart{0.25, 0.5, 0.99, 1.0, 1.01, 1.99, 2.0, 3.0};
  const double apart = reach * kApart[static_cast<std::size_t>(s.below(8))];
  for (int n = s.between(10, 100); n > 0; --n) {
    if (placed && s.below(3) == 0) {
      g.create_transformation_3();
      g.rotate_x_3(30.0);
      if (s.below(2) == 0) g.translate_3(0.1, 0.2, 0.3);
      if (s.below(4) == 0) g.scale_3(1.0, 0.5, 1.5);
    }
    std::vector<Point3> polygon =
        any_flat(s, std::ldexp(1.0, -s.below(s.below(4) == 0 ? 60 : 8)), s.between(3, 7));
    const double narrow = s.below(5) == 0 ? std::ldexp(1.0, -s.below(55)) : 1.0;
    const double x = decimal(s, -1, 1), y = decimal(s, -1, 1);
    const double z = apart * s.between(-12, 12);
    for (Point3& p : polygon) p = {p.x + x, narrow * p.y + y, z};
    g.polygon_abs_3(polygon);
  }
  // The largest coordinate, and so the reach, is known.
  g.create_transformation_3();
  g.polygon_abs_3({{8, 0, 0}, {8, 1, 0}, {8, 0, 1}});
}

TEST(TouchingPlanes, OfSheetsApartByFractionsAndMultiplesOfTheReach) {
  for (const bool placed : {false, true}) {
    EXPECT_GT(expect_truth_of(
                  {}, [&](Source& s, GraphicsSystem& g) { enter_sheets(s, g, 0x1p-46, placed); }),
              scenes());
    EXPECT_GT(
        expect_truth_of(within(0.01),
                        [&](Source& s, GraphicsSystem& g) { enter_sheets(s, g, 0.01, placed); }),
        scenes());
  }
}

/// Narrower and smaller than sums of two doubles resolve, in two planes, or off them by tiny
/// amounts.
TEST(TouchingPlanes, OfSliversOfAnyWidth) {
  const std::size_t touch = expect_truth_of(within(1e-60), [](Source& s, GraphicsSystem& g) {
    for (int n = s.below(2) == 0 ? s.between(5, 40) : 3; n > 0; --n) {
      const int slope = s.below(2), size = s.below(90);
      const int width = s.below(3) == 0 ? size : s.below(160);
      std::vector<Point3> polygon;
      for (int sides = 3; sides > 0; --sides) {
        const double x = std::ldexp(s.between(-9, 9), -size);
        const double y = std::ldexp(s.between(-9, 9), -width);
        const double off = s.below(20) == 0 ? std::ldexp(s.between(-3, 3), -200) : 0.0;
        polygon.emplace_back(x, y, slope * y + off);
      }
      g.polygon_abs_3(polygon);
    }
  });
  EXPECT_GT(touch, scenes());
}

/// A polygon lies in the plane of one that is larger but so narrow that only exact numbers
/// determine its plane.
TEST(TouchingPlanes, APolygonLiesInThePlaneOfALargerSliver) {
  const double narrow = 0x1p-120, small = 0x1p-62;
  const Triangles triangles{{Point3(0, 0, 0), Point3(1, 0, 0), Point3(0.5, narrow, narrow)},
                            {Point3(0, 0, 0), Point3(small, 0, 0), Point3(0, small, small)},
                            {Point3(0, 0, 0), Point3(small, 0, 0), Point3(0, small, -small)}};
  const TouchingPlanes planes = planes_of(triangles, 1e-60);
  EXPECT_EQ(planes.plane_of(0), 0u);
  EXPECT_EQ(planes.plane_of(1), 0u);
  EXPECT_EQ(planes.plane_of(2), 2u);
}

/// Some in line, some with points that coincide, some so nearly in line that only exact numbers
/// decide; also where a modelling transformation flattens them.
void enter_degenerate(Source& s, GraphicsSystem& g) {
  for (int n = s.between(10, 60); n > 0; --n) {
    if (s.below(6) == 0) {
      g.create_transformation_3();
      const auto factor = [&] { return s.below(3) == 0 ? 0.0 : decimal(s, -2, 2, 1); };
      const double x = factor(), y = factor(), z = factor();
      g.scale_3(x, y, z);
      if (s.below(2) == 0) test::turn_and_move(s, g);
    }
    std::vector<Point3> polygon;
    const Point3 from(decimal(s, -1, 1), decimal(s, -1, 1), decimal(s, -1, 1));
    const Point3 along(decimal(s, -1, 1), decimal(s, -1, 1), decimal(s, -1, 1));
    for (int sides = s.between(3, 6); sides > 0; --sides) {
      Point3 p = from + along * (0.25 * s.between(0, 6));
      if (s.below(4) == 0) p = from;
      if (s.below(4) == 0) p.x = std::nextafter(p.x, 9.0);
      if (s.below(6) == 0) p.y += 0.5;
      polygon.push_back(p);
    }
    g.polygon_abs_3(polygon);
  }
}

TEST(TouchingPlanes, OfDegeneratePolygonsAndFlatteningTransformations) {
  EXPECT_GT(expect_truth_of({}, enter_degenerate), 0u);
  EXPECT_GT(expect_truth_of(within(0.01), enter_degenerate), 0u);
  EXPECT_GT(expect_truth_of(within(1e-15), enter_degenerate), 0u);
}

/// Coordinates near the limit, tiny ones, and both, under scales up to the limit.
TEST(TouchingPlanes, OfCoordinatesOfAnySize) {
  std::size_t touch = 0;
  for (const Touching& touching : {Touching{}, within(1e-300), within(1e80), within(1e100)}) {
    touch += expect_truth_of(touching, [](Source& s, GraphicsSystem& g) {
      const int exponent = s.between(-160, 98);
      const double size = std::pow(10.0, exponent);
      for (int n = s.between(5, 40); n > 0; --n) {
        if (s.below(6) == 0) g.create_transformation_3();
        if (s.below(6) == 0) {
          g.create_transformation_3();
          const double scale = std::pow(10.0, s.between(-99, std::min(98 - exponent, 99)));
          g.scale_3(scale, scale, scale);
          g.rotate_z_3(30.0);
        }
        std::vector<Point3> polygon = s.below(2) == 0 ? test::triangle(s) : test::flat(s);
        const double here = s.below(4) == 0 ? size * std::pow(10.0, -s.below(40)) : size;
        for (Point3& p : polygon) p *= here;
        g.polygon_abs_3(polygon);
      }
    });
  }
  EXPECT_GT(touch, 0u);
}

/// Small triangles at the far corners of a large rectangle, whose own planes are tilted as much as
/// the reach allows: their keys are as far from the rectangle's as possible.
TEST(TouchingPlanes, OfSmallPolygonsThatAreTiltedAsFarAsTheReachLets) {
  const double reach = 1e-4, size = 0.99;
  const Point3 along = Point3(1, 1, 0) / std::sqrt(2.0), up(0, 0, 1);
  const Point3 across = Point3(1, -1, 0) / std::sqrt(2.0);
  const std::size_t touch = expect_truth_of(within(reach), [&](Source& s, GraphicsSystem& g) {
    g.polygon_abs_3(
        {{-size, -size, -size}, {size, size, -size}, {size, size, size}, {-size, -size, size}});
    for (int n = 0; n < 24; ++n) {
      const Point3 corner = (s.below(2) == 0 ? 1.0 : -1.0) * size * std::sqrt(2.0) * along +
                            (s.below(2) == 0 ? 1.0 : -1.0) * size * up;
      const double angle = 2.0 * std::numbers::pi * s.unit(), height = reach * s.between(6, 60);
      const Point3 to = std::cos(angle) * along + std::sin(angle) * up;
      const Point3 side = std::cos(angle) * up - std::sin(angle) * along;
      const Point3 off = (s.below(2) == 0 ? 0.999 : -0.999) * reach * across;
      g.polygon_abs_3({0.999 * corner + height * to + off, 0.999 * corner - height * side - off,
                       0.999 * corner + height * side - off});
    }
  });
  EXPECT_EQ(touch, 24 * scenes());
}

/// Whatever rounding mode the host has set when planes are looked for.
TEST(TouchingPlanes, InEveryRoundingMode) {
  for (const int mode : test::kModes) {
    for (std::uint64_t seed = 0; seed < scenes() / 4; ++seed) {
      SCOPED_TRACE(fmt::format("mode {}, seed {}", mode, seed));
      Source s(seed);
      Retained retained;
      retained.system.open_segment(1);
      s.below(2) == 0 ? enter_sheets(s, retained.system, 0x1p-46, true)
                      : enter_degenerate(s, retained.system);
      retained.system.close_segment();
      const RetainedScene& scene = retained.scene;
      const TruePlanes expected(scene, {});
      TouchingPlanes found;
      // The mode is unchanged afterwards.
      ASSERT_EQ(test::in_mode(mode,
                              [&] {
                                found = planes_of(scene, {});
                                return std::fegetround();
                              }),
                mode);
      ASSERT_GT(scene.size(), 0u);
      for (std::uint32_t i = 0; i < scene.size(); ++i) {
        ASSERT_EQ(found.plane_of(i), expected.plane_of(i)) << "polygon " << i;
      }
    }
  }
}

/// A closed surface of triangles, larger ones first as it comes, whose planes the tree finds.
Triangles sphere(int rings) {
  Triangles triangles;
  const auto at = [&](int ring, int k) {
    const double u = std::numbers::pi * ring / rings, v = std::numbers::pi * k / rings;
    return Point3(std::sin(u) * std::cos(v), std::sin(u) * std::sin(v), std::cos(u));
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int k = 0; k < 2 * rings; ++k) {
      const Point3 a = at(ring, k), b = at(ring, k + 1), c = at(ring + 1, k);
      const Point3 d = at(ring + 1, k + 1);
      if (ring > 0) triangles.push_back({a, c, b});
      if (ring + 1 < rings) triangles.push_back({b, c, d});
    }
  }
  return triangles;
}

TEST(TouchingPlanes, OfCurvedSurfacesWithinALength) {
  for (const double length : {1e-9, 1e-4, 1e-3, 1e-2, 0.1, 0.7}) {
    SCOPED_TRACE(length);
    Retained retained;
    retained.system.open_segment(1);
    retained.system.rotate_x_3(30.0);
    for (const auto& triangle : sphere(test::kSlower == 1 ? 18 : 6)) {
      retained.system.polygon_abs_3(triangle);
    }
    retained.system.close_segment();
    EXPECT_GT(expect_truth(retained.scene, within(length)), 0u);
  }
}

TEST(TouchingPlanes, OfNothing) {
  const TouchingPlanes none;
  EXPECT_EQ(none.touching(), 0u);
  EXPECT_EQ(none.shared_planes(), 0u);
  const TouchingPlanes empty(
      0,
      [](std::uint32_t) {
        return EnteredPolygon{std::vector<Point3>(), nullptr};
      },
      0.1);
  EXPECT_EQ(empty.touching(), 0u);
}

std::array<Point3, 3> any_triangle(Source& s, double size) {
  const auto any = [&] {
    const double x = s.unit(), y = s.unit(), z = s.unit();
    return Point3(x, y, z);
  };
  const Point3 at = any();
  return {at, at + size * (any() - 0.5), at + size * (any() - 0.5)};
}

/// Triangles in planes z = k apart, k below `planes`.
Triangles sheets(std::size_t n, std::size_t planes, double apart, double size) {
  Source s(1);
  Triangles triangles;
  for (std::size_t k = 0; k < n; ++k) {
    std::array<Point3, 3> triangle = any_triangle(s, size);
    for (Point3& p : triangle) p.z = apart * static_cast<double>(k % planes);
    triangles.push_back(triangle);
  }
  return triangles;
}

/// The number of comparisons that a polygon takes part in.
double per_polygon(const Triangles& triangles, double reach) {
  const TouchingPlanes::Counts counts = planes_of(triangles, reach).counts();
  return static_cast<double>(counts.compared + counts.tested) /
         static_cast<double>(triangles.size());
}

Triangles soup(std::size_t n, double size) {
  Source s(2);
  Triangles triangles;
  while (triangles.size() < n) triangles.push_back(any_triangle(s, size));
  return triangles;
}

/// A polygon is compared with few planes, however many there are.
TEST(TouchingPlanes, APolygonIsComparedWithFew) {
  constexpr double kReach = 0x1p-49;
  const std::size_t n = test::kSlower == 1 ? 16000 : 3000;
  EXPECT_LT(per_polygon(sheets(n, 1, 0.0, 0.1), kReach), 5.0);
  EXPECT_LT(per_polygon(soup(n, 1.0), kReach), 1.0);
  EXPECT_LT(per_polygon(soup(n, 1e-4), kReach), 1.0);
  constexpr double kFew = 120.0;
  EXPECT_LT(per_polygon(sheets(n, n, 1.01 * kReach, 1.0), kReach), kFew);
  EXPECT_LT(per_polygon(sheets(n, n, 1.01 * kReach, 1e-4), kReach), kFew);
  EXPECT_LT(per_polygon(sheets(n, n, 0.4 * kReach, 1e-3), kReach), kFew);
  EXPECT_LT(per_polygon(sheets(n, n / 10, 0.9 * kReach, 1e-3), kReach), kFew);
  EXPECT_LT(per_polygon(sheets(n, n, 0x1p-53, 1.0), kReach), kFew);
  EXPECT_LT(per_polygon(sheets(n, n, 1e-12, 1e-3), kReach), kFew);
  EXPECT_LT(per_polygon(soup(n, 1e-10), kReach), kFew);
  const Triangles ball = sphere(static_cast<int>(std::sqrt(static_cast<double>(n) / 4.0)));
  for (const double reach : {kReach, 0x1p-30, 0x1p-21, 0x1p-15}) {
    EXPECT_LT(per_polygon(ball, reach), kFew) << reach;
  }
}

/// Where polygons touch up to rounding, exact numbers are hardly needed.
TEST(TouchingPlanes, DecidesWhatTouchesWithoutExactNumbers) {
  Source s(3);
  const glm::dmat4x3 matrix = any_matrix(s);
  Triangles triangles;
  for (int k = 0; k < 500; ++k) {
    const double rise = 0.37, foot = decimal(s, 0, 1);
    std::array<Point3, 3> triangle;
    for (Point3& p : triangle) {
      const double x = decimal(s, -2, 2), z = decimal(s, -2, 2);
      p = {x, foot + rise * z, z};
    }
    triangles.push_back(triangle);
  }
  for (const glm::dmat4x3* const placing : {static_cast<const glm::dmat4x3*>(nullptr), &matrix}) {
    reset_predicate_counts();
    EXPECT_GT(planes_of(triangles, 0x1p-48, placing).touching(), 300u);
    EXPECT_EQ(predicate_counts()[static_cast<std::size_t>(Predicate::within_reach)].exact, 0u);
  }
}

TEST(TouchingPlanes, ObeysTheBudget) {
  const Triangles triangles = sheets(5000, 1, 0.0, 0.1);
  WorkBudget budget;
  const BudgetInForce in_force(budget);
  budget.stop();
  EXPECT_THROW(planes_of(triangles, 0x1p-49), LimitReached);
}

}  // namespace
}  // namespace displayfile
