// The truth from the scene as entered: against the definition in rationals, and against pictures
// whose answer is known.

#include "interp/truth/entered_truth.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "clip/base/error.h"
#include "interp/truth/true_planes.h"
#include "interp/truth/world_truth.h"
#include "programs/scenes/scene.h"
#include "tests/brute_force_entered_truth.h"
#include "tests/retained_truth.h"
#include "tests/scenes_that_clip.h"
#include "tests/slower.h"
#include "tests/touching_scenes.h"

namespace displayfile {
namespace {

using test::decimal;
using test::Retained;
using test::Source;

constexpr Touching kOff{Touching::Kind::off};
const test::Ball3 kAboutTheOrigin{Point3(0.0), 3.0};

EnteredTruth truth_of(const Retained& retained, int width, int height,
                      const Touching& touching = {}) {
  return entered_truth(retained.scene, retained.system.display_file(), width, height, true,
                       touching);
}

void expect_brute_force(const Retained& retained, int width, int height, const Touching& touching) {
  const test::BruteForceEnteredTruth expected(retained.scene, retained.system.display_file(), width,
                                              height, touching);
  const EnteredTruth found = truth_of(retained, width, height, touching);
  ASSERT_EQ(found.touching, expected.touching());
  const Picture picture = expected.picture();
  ASSERT_EQ(found.picture.ids, picture.ids);
  ASSERT_EQ(found.picture.depth, picture.depth);
}

std::size_t covered_pixels(const Picture& picture) {
  return picture.ids.size() - static_cast<std::size_t>(std::ranges::count(picture.ids, -1));
}

/// Polygons on a coarse grid, each call under a modelling transformation of its own or that of the
/// one before.
void enter_on_grid(Source& s, GraphicsSystem& g, Polygon (*polygon)(Source&)) {
  test::view_from_anywhere(s, g);
  g.set_front_plane_clipping(s.below(3) == 0);
  g.set_back_plane_clipping(s.below(3) == 0);
  // The orientation of a concave polygon is not found by the rationals.
  g.set_back_face_removal(polygon == test::triangle && s.below(3) == 0);
  g.open_segment(1);
  for (int n = s.between(2, 6); n > 0; --n) {
    if (s.below(3) == 0) g.create_transformation_3();
    if (s.below(3) == 0) test::turn_and_move(s, g);
    g.polygon_abs_3(polygon(s));
  }
  g.close_segment();
  g.set_image_scale(1, 0.25 * s.between(1, 6), 0.25 * s.between(1, 6));
  if (s.below(2) == 0) g.set_image_rotation(1, decimal(s, 0, 360));
}

void expect_brute_force_of(Polygon (*polygon)(Source&), const Touching& touching) {
  std::size_t covered = 0;
  for (std::uint64_t seed = 0; seed < 24 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(seed);
    Retained retained;
    enter_on_grid(s, retained.system, polygon);
    ASSERT_NO_FATAL_FAILURE(expect_brute_force(retained, 14, 11, touching));
    covered += covered_pixels(truth_of(retained, 14, 11, touching).picture);
  }
  EXPECT_GT(covered, test::kSlower == 1 ? 150u : 0u);
}

TEST(EnteredTruth, OfTrianglesIsThatOfBruteForceInRationals) {
  expect_brute_force_of(test::triangle, {});
  expect_brute_force_of(test::triangle, kOff);
}
TEST(EnteredTruth, OfFlatPolygonsIsThatOfBruteForceInRationals) {
  expect_brute_force_of(test::flat, {});
  expect_brute_force_of(test::flat, kOff);
}
TEST(EnteredTruth, WithinALengthIsThatOfBruteForceInRationals) {
  expect_brute_force_of(test::triangle, {Touching::Kind::length, 0.3});
  expect_brute_force_of(test::flat, {Touching::Kind::length, 0.05});
}

/// Which polygon of two is seen where both are, in random views.
template <class Enter>
void expect_second_on_first(Enter&& enter, bool transformed) {
  std::size_t both = 0;
  for (std::uint64_t seed = 0; seed < 40 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(seed);
    Retained retained;
    GraphicsSystem& g = retained.system;
    test::view_from_anywhere(s, g, kAboutTheOrigin);
    if (transformed) test::turn_and_move(s, g);
    g.open_segment(1);
    enter(s, g);
    g.close_segment();
    ASSERT_NO_FATAL_FAILURE(expect_brute_force(retained, 9, 7, {}));
    // Alone, polygon 1 covers the same pixels as on the other.
    const EnteredTruth found = truth_of(retained, 32, 32);
    ASSERT_EQ(found.touching, 1u);
    RetainedScene alone;
    GraphicsSystem second;
    second.retain(&alone);
    Source again(seed);
    test::view_from_anywhere(again, second, kAboutTheOrigin);
    second.open_segment(1);
    const RetainedScene::Primitive& polygon = retained.scene[1];
    ASSERT_EQ(polygon.pick, 1);
    second.set_pick_id(1);
    second.polygon_abs_3(
        std::vector<Point3>(retained.scene.points(1).begin(), retained.scene.points(1).end()));
    second.close_segment();
    const auto covered = entered_truth(alone, second.display_file(), 32, 32, false, {}).picture.ids;
    for (std::size_t k = 0; k < covered.size(); ++k) {
      if (covered[k] == 1) {
        EXPECT_EQ(found.picture.ids[k], 1);
      }
    }
    both += static_cast<std::size_t>(std::ranges::count(covered, 1));
  }
  EXPECT_GT(both, test::kSlower == 1 ? 250u : 0u);
}

TEST(EnteredTruth, ARugInTheFloorsPlaneIsWhole) {
  expect_second_on_first(test::enter_rug_on_floor, false);
  expect_second_on_first(test::enter_rug_on_floor, true);
}
TEST(EnteredTruth, AWindowInDecimalsInAPitchedRoofIsWhole) {
  expect_second_on_first(test::enter_window_in_roof, false);
  expect_second_on_first(test::enter_window_in_roof, true);
}

/// Points farther than the reach stay where they were entered, in front or behind.
TEST(EnteredTruth, WhatLiesBeyondReachIsApart) {
  // The largest coordinate is 2, so the reach is 2^-48.
  for (const auto& [lift, seen] : {std::pair{0x1p-48, 1},
                                   {-0x1p-48, 1},
                                   {0x1.8p-48, 1},
                                   {-0x1.8p-48, 0},
                                   {1e-9, 1},
                                   {-1e-9, 0}}) {
    SCOPED_TRACE(lift);
    Retained retained;
    GraphicsSystem& g = retained.system;
    g.set_window(-2, 2, -2, 2);
    g.open_segment(1);
    g.polygon_abs_3({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
    g.polygon_abs_3({{-1, -1, lift}, {1, -1, lift}, {1, 1, lift}, {-1, 1, lift}});
    g.close_segment();
    const bool touch = std::abs(lift) <= 0x1p-48;
    EXPECT_EQ(truth_of(retained, 4, 4).touching, touch ? 1u : 0u);
    EXPECT_EQ(truth_of(retained, 4, 4).picture.ids[5], seen);
    EXPECT_EQ(truth_of(retained, 4, 4, kOff).picture.ids[5], lift > 0.0 ? 1 : 0);
    EXPECT_EQ(truth_of(retained, 4, 4, {Touching::Kind::length, 1e-8}).picture.ids[5], 1);
    const EnteredTruth within = truth_of(retained, 4, 4, {Touching::Kind::length, 1e-10});
    EXPECT_EQ(within.touching, std::abs(lift) <= 1e-10 ? 1u : 0u);
  }
}

/// A modelling transformation multiplies the reach by the length of its longest column.
TEST(EnteredTruth, ReachGrowsWithTheModellingTransformation) {
  for (const double scale : {0.25, 1.0, 8.0}) {
    for (const double lift : {0x1p-48 * scale, 0x1.0001p-48 * scale}) {
      Retained retained;
      GraphicsSystem& g = retained.system;
      g.set_window(-20, 20, -20, 20);
      g.set_view_depth(-2, 2);
      g.scale_3(scale, 1, 0.125);
      g.open_segment(1);
      g.polygon_abs_3({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
      g.create_transformation_3();
      g.scale_3(0.125, 0.125, 0.125);
      g.polygon_abs_3({{-1, -1, 8 * lift}, {1, -1, 8 * lift}, {1, 1, 8 * lift}});
      g.close_segment();
      const double reach = 0x1p-48 * std::max(scale, 1.0);
      EXPECT_EQ(truth_of(retained, 4, 4).touching, lift <= reach ? 1u : 0u) << scale << ' ' << lift;
    }
  }
}

/// The largest of several polygons within reach has the plane that all lie in; none is joined
/// to a plane that it is farther from than the reach, though others are between.
TEST(EnteredTruth, PolygonsLieInThePlaneOfTheLargest) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_window(-2, 2, -2, 2);
  g.open_segment(1);
  const auto square = [&](double half, double z) {
    g.polygon_abs_3({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
  };
  square(0.5, 0.0);
  square(1.0, 0x1p-48);
  square(2.0, 0x1p-47);
  square(0.25, 0x1p-47);
  g.close_segment();
  const TruePlanes planes(retained.scene, {});
  EXPECT_EQ(planes.plane_of(0), 0u);  // 2^-47 from the largest
  EXPECT_EQ(planes.plane_of(1), 2u);
  EXPECT_EQ(planes.plane_of(2), 2u);
  EXPECT_EQ(planes.plane_of(3), 2u);
  EXPECT_EQ(planes.touching(), 2u);
}

/// Without touching and modelling transformations it equals the truth from world coordinates, whose
/// triangles have the same planes.
TEST(EnteredTruth, WithoutTouchingIsThatFromWorldCoordinates) {
  for (std::uint64_t seed = 0; seed < 40 / test::kSlower; ++seed) {
    Source s(seed);
    Retained retained;
    GraphicsSystem& g = retained.system;
    test::view_from_anywhere(s, g);
    g.open_segment(1);
    for (int n = 0; n < 5; ++n) g.polygon_abs_3(test::triangle(s));
    g.close_segment();
    const Picture world = world_truth(retained.scene, g.display_file(), 20, 20, true);
    const Picture entered = truth_of(retained, 20, 20, kOff).picture;
    ASSERT_EQ(entered.ids, world.ids);
    ASSERT_EQ(entered.depth, world.depth);
  }
}

/// A retained scene keeps its input: points, matrices, also of shared vertices, after a segment is
/// deleted, and of surfaces.
TEST(EnteredTruth, RetainedScenesKeepPointsAndMatricesAsEntered) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  const std::vector<Point3> triangle{{0.1, 0.2, 0.3}, {0.7, 0.1, 0.2}, {0.3, 0.9, 0.4}};
  const std::vector<Point3> vertices{{0.1, 0, 0}, {0.2, 0, 0}, {0.2, 0.3, 0}, {0.1, 0.3, 0.7}};
  const std::vector<std::uint32_t> corners{0, 1, 2, 0, 2, 3};
  const std::vector<double> heights{0.1, 0.2, 0.3, 0.4};
  glm::dmat4 matrix(1.0);
  const auto enter_segment = [&](int name, bool turned) {
    g.create_transformation_3();
    g.open_segment(name);
    g.polygon_abs_3(triangle);
    if (turned) g.rotate_z_3(31.7);
    if (turned) g.translate_3(0.1, 0.2, 0.3);
    matrix = g.modelling_transformation().matrix();
    g.polygons_abs_3({vertices, corners});
    g.surface_3({.x_min = 0,
                 .x_max = 0.3,
                 .x_points = 2,
                 .y_min = 0,
                 .y_max = 0.7,
                 .y_points = 2,
                 .heights = heights});
    g.close_segment();
  };
  const auto expect_segment = [&](std::uint32_t first, bool turned) {
    const RetainedScene& scene = retained.scene;
    const auto entered = [&](std::uint32_t i) {
      const PointRow row = scene.entered_points(i);
      return std::vector<Point3>(row.begin(), row.end());
    };
    const RetainedScene::ModellingMatrix as_set(turned ? matrix : glm::dmat4(1.0));
    EXPECT_EQ(entered(first), triangle);
    EXPECT_EQ(scene.modelling_matrix(first), RetainedScene::ModellingMatrix(1.0));
    EXPECT_EQ(entered(first + 2), (std::vector{vertices[0], vertices[2], vertices[3]}));
    EXPECT_EQ(entered(first + 3),
              (std::vector<Point3>{{0, 0, 0.1}, {0.3, 0, 0.2}, {0.3, 0.7, 0.4}}));
    for (std::uint32_t i = first + 1; i < first + 5; ++i) {
      EXPECT_EQ(scene.modelling_matrix(i), as_set) << i;
      const PointRow world = scene.points(i);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(world[k], Point3(as_set * HomogeneousPoint(entered(i)[k], 1.0)));
      }
    }
  };
  enter_segment(1, false);
  expect_segment(0, false);
  enter_segment(2, true);
  const glm::dmat4 turned = matrix;
  enter_segment(3, false);
  matrix = turned;
  expect_segment(0, false);
  expect_segment(5, true);
  expect_segment(10, false);
  g.delete_segment(1);
  expect_segment(0, true);
  expect_segment(5, false);
  g.delete_segment(2);
  expect_segment(0, false);
  enter_segment(4, true);
  expect_segment(5, true);
}

TEST(EnteredTruth, SupportVerticesAreThoseOfTheDefinition) {
  using Support = std::optional<std::array<std::size_t, 3>>;
  const auto support = [](const std::vector<Point3>& polygon) { return entered_support(polygon); };
  EXPECT_EQ(support({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Support{{0, 1, 2}}));
  EXPECT_EQ(support({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), Support());
  // The farthest along an axis, the first of equals; then the largest component of the product.
  EXPECT_EQ(support({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Support{{0, 1, 2}}));
  EXPECT_EQ(support({{0, 0, 0}, {1, 0, 0}, {3, 1, 0}, {0, 2, 0}}), (Support{{0, 2, 3}}));
  // Small as it is, it has a plane; the measures would underflow without the power of two.
  EXPECT_EQ(support({{0, 0, 0}, {1e-200, 0, 0}, {3e-200, 1e-200, 0}, {0, 2e-200, 0}}),
            (Support{{0, 2, 3}}));
  EXPECT_EQ(support({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}), Support());
  EXPECT_EQ(support({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), Support());
}

TEST(EnteredTruth, WordsOfTouching) {
  EXPECT_EQ(touching("auto"), Touching{});
  EXPECT_EQ(touching("off"), kOff);
  EXPECT_EQ(touching("0.001"), (Touching{Touching::Kind::length, 0.001}));
  for (const char* word : {"", "on", "0", "-1", "1e101", "nan", "inf", "1mm", "0x1", " 1"}) {
    EXPECT_THROW(touching(word), Error) << word;
  }
}

}  // namespace
}  // namespace displayfile
