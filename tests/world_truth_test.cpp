// The truth from world coordinates: against the brute-force check in rationals, and against the
// display file's truth where viewing rounds nothing.

#include "interp/truth/world_truth.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "programs/scenes/hard_cases.h"
#include "programs/scenes/scene.h"
#include "tests/brute_force_world_truth.h"
#include "tests/random_views.h"
#include "tests/retained_truth.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using test::Retained;
using test::Source;

/// On a coarse grid about the unit cube, so that polygons touch, cross and coincide.
double step(Source& s) { return s.between(-1, 5) / 4.0; }
Point3 any_vertex(Source& s) {
  if (s.below(4) == 0) return {s.unit(), s.unit(), s.unit()};
  return {step(s), step(s), step(s)};
}

Polygon triangle(Source& s) { return {any_vertex(s), any_vertex(s), any_vertex(s)}; }

/// In one plane exactly; concave and self-crossing as it comes.
Polygon flat(Source& s) {
  const int kind = s.below(3);
  const double at = step(s);
  Polygon polygon;
  for (int sides = s.between(4, 7); sides > 0; --sides) {
    const double a = step(s), b = step(s);
    if (kind == 0) polygon.push_back({a, b, at});
    if (kind == 1) polygon.push_back({at, a, b});
    if (kind == 2) polygon.push_back({a, b, at - a - b});
  }
  return polygon;
}

/// Flat within the tolerance only.
Polygon bent(Source& s) {
  Polygon polygon = {{0.125, 0.25, 0.5}, {0.875, 0.25, 0.5}, {0.875, 0.75, 0.5}, {0.25, 0.75, 0.5}};
  for (Point3& p : polygon) p.z += 1e-7 * s.unit();
  return polygon;
}

/// Some clip, some are set in a corner of the picture.
View any_clipping_view(Source& s) {
  View view = test::any_view(s);
  view.front_clipping = s.below(3) == 0;
  view.back_clipping = s.below(3) == 0;
  if (view.back_clipping) view.set_depth(view.front, view.front + (view.back - view.front) * 0.4);
  if (s.below(3) == 0) view.set_viewport({0.25, 0.75, 0.0, s.below(2) == 0 ? 0.5 : 0.7});
  return view;
}

ImageTransformation any_image(Source& s) {
  ImageTransformation image;
  if (s.below(2) == 0) return image;
  image.centre = {0.5, 0.5};
  image.scale = {0.25 * s.between(-4, 6), 0.25 * s.between(1, 6)};
  image.rotation = s.below(2) == 0 ? 0.0 : 360.0 * s.unit();
  image.translation = {0.125 * s.between(-2, 2), 0.0};
  return image;
}

void enter_all(const Scene& scene, bool back_face_removal, Retained& retained) {
  GraphicsSystem& g = retained.system;
  g.set_back_face_removal(back_face_removal);
  const Rectangle& port = scene.view.viewport;
  g.set_viewport(port.x_min, port.x_max, port.y_min, port.y_max);
  enter(scene, g);
  for (std::size_t i = 0; i < scene.segments.size(); ++i) {
    const Point2& centre = scene.segments[i].image.centre;
    g.set_image_centre(static_cast<int>(i) + 1, centre.x, centre.y);
  }
}

void expect_brute_force(const Retained& retained, int width, int height) {
  const DisplayFile& file = retained.system.display_file();
  const Picture expected =
      test::BruteForceWorldTruth(retained.scene, file, width, height).picture();
  const Picture found = world_truth(retained.scene, file, width, height, true);
  ASSERT_EQ(found.ids, expected.ids);
  ASSERT_EQ(found.depth, expected.depth);
  ASSERT_EQ(world_truth(retained.scene, file, width, height, false).ids, expected.ids);
}

void expect_brute_force_of(Polygon (*polygon)(Source&), bool removal, bool clipped) {
  std::size_t covered = 0;
  for (std::uint64_t seed = 0; seed < 40 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(seed);
    Scene scene;
    scene.view = clipped ? any_clipping_view(s) : test::any_parallel_view(s);
    for (int segment = s.between(1, 2); segment > 0; --segment) {
      scene.open_segment(any_image(s));
      for (int n = s.between(1, 4); n > 0; --n) scene.add(polygon(s));
    }
    Retained retained;
    enter_all(scene, removal, retained);
    ASSERT_NO_FATAL_FAILURE(expect_brute_force(retained, 14, 11));
    const Picture picture =
        world_truth(retained.scene, retained.system.display_file(), 14, 11, false);
    covered += picture.ids.size() - static_cast<std::size_t>(std::ranges::count(picture.ids, -1));
  }
  // The scenes are not empty; of a few, most may be.
  EXPECT_GT(covered, test::kSlower == 1 ? 300u : 0u);
}

TEST(WorldTruth, OfTrianglesIsThatOfBruteForceInRationals) {
  expect_brute_force_of(triangle, false, true);
}
TEST(WorldTruth, WithBackFacesRemovedIsThatOfBruteForceInRationals) {
  expect_brute_force_of(triangle, true, true);
}
TEST(WorldTruth, OfFlatPolygonsIsThatOfBruteForceInRationals) {
  expect_brute_force_of(flat, false, true);
}
TEST(WorldTruth, TakesTheSupportPlaneThroughTheVerticesOfTheDisplayFile) {
  expect_brute_force_of(bent, false, false);
}

/// Edges and vertices exactly at centres, and front and back planes exactly through them.
TEST(WorldTruth, CentresOnEdgesAndOnClipPlanesAreThoseOfBruteForce) {
  for (std::uint64_t seed = 0; seed < 40 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(seed);
    Scene scene;  // in device coordinates
    scene.view.front_clipping = scene.view.back_clipping = true;
    scene.view.set_depth(-0.75, -0.25);
    if (s.below(2) == 0) scene.view.set_viewport({0.125, 0.625, 0.0, 0.5});
    const auto eighth = [&] { return s.between(-1, 9) / 8.0; };
    for (int n = s.between(1, 4); n > 0; --n) {
      scene.add({{eighth(), eighth(), eighth()},
                 {eighth(), eighth(), eighth()},
                 {eighth(), eighth(), eighth()}});
    }
    Retained retained;
    enter_all(scene, false, retained);
    ASSERT_NO_FATAL_FAILURE(expect_brute_force(retained, 8, 4));
  }
}

/// In the unit view world coordinates are device coordinates, to the last bit.
TEST(WorldTruth, IsTheDisplayFilesWhereViewingDoesNotRound) {
  std::size_t scenes = 0;
  for (const HardCase& family : hard_cases()) {
    const Scene scene = family.make(family.size, family.severities.front(), 1);
    if (!(scene.view == unit_view()) || !scene.segments.empty()) continue;
    Retained retained;
    enter(scene, retained.system);
    const DisplayFile& file = retained.system.display_file();
    const bool clipped = std::ranges::any_of(scene.points, [](const Point3& p) {
      return !(p.x >= 0.0 && p.x <= 1.0 && p.y >= 0.0 && p.y <= 1.0);
    });
    if (clipped) continue;  // rounds where it cuts
    const Picture of_file = truth(file, 48, 48, true);
    const Picture of_world = world_truth(retained.scene, file, 48, 48, true);
    EXPECT_EQ(different_pixels(of_file, of_world), 0u) << family.name;
    EXPECT_EQ(of_file.depth, of_world.depth) << family.name;
    ++scenes;
  }
  EXPECT_GT(scenes, 30u);
}

TEST(WorldTruth, SeesVisibleSegmentsAndSolidPolygonsOnly) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.open_segment(1);
  g.polygon_abs_3({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  g.close_segment();
  g.open_segment(2);
  g.set_fill_style({FillStyle::Kind::hollow});
  g.polygon_abs_3({{-1, -1, 0.5}, {1, -1, 0.5}, {1, 1, 0.5}, {-1, 1, 0.5}});
  g.move_abs_3(0, 0, 0.9);
  g.line_abs_3(1, 1, 0.9);
  g.close_segment();
  std::vector<std::size_t> counts;
  const auto ids = [&] {
    return world_truth(retained.scene, g.display_file(), 2, 2, false,
                       [&](std::size_t done, std::size_t all) {
                         counts.push_back(done);
                         EXPECT_LE(done, all);
                       })
        .ids;
  };
  EXPECT_EQ(ids(), (std::vector<std::int32_t>{0, 0, 0, 0}));
  EXPECT_EQ(counts, (std::vector<std::size_t>{1, 2, 3}));
  g.set_visibility(1, false);
  EXPECT_EQ(ids(), (std::vector<std::int32_t>{-1, -1, -1, -1}));
}

}  // namespace
}  // namespace displayfile
