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
#include "tests/brute_force_world_truth.h"
#include "tests/retained_truth.h"
#include "tests/scenes_that_clip.h"
#include "tests/slower.h"

namespace displayfile {
namespace {

using test::any_clipping_view;
using test::bent;
using test::flat;
using test::Retained;
using test::Source;
using test::triangle;

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

/// A face on the front plane, or on the back plane, is inside of it wherever these are set,
/// whatever their distances and the eye's make of the entries of the matrix.
TEST(WorldTruth, WhatLiesOnTheFrontOrBackPlaneIsInside) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Source s(seed);
    const bool tenths = s.below(2) == 0;
    const auto any = [&](int low, int high) {
      return tenths ? s.between(10 * low, 10 * high) / 10.0 : low + (high - low) * s.unit();
    };
    Retained retained;
    GraphicsSystem& g = retained.system;
    const double front = any(-2, 0), back = front + any(1, 3);
    const Point3 eye{any(-2, 2), any(-2, 2), any(3, 9)};
    if (s.below(4) == 0) {
      g.set_parallel(eye);
    } else {
      g.set_perspective(eye);
    }
    g.set_view_depth(front, back);
    g.set_front_plane_clipping(true);
    g.set_back_plane_clipping(true);
    g.open_segment(1);
    for (const double z : {-back, -front}) {
      g.polygon_abs_3({{-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}});
    }
    g.polygon_abs_3({{0, 0, -front}, {9, 0, -front}, {9, 9, std::nextafter(-front, 9.0)}});
    g.close_segment();
    ASSERT_NO_FATAL_FAILURE(expect_brute_force(retained, 5, 4));
    const auto seen = world_truth(retained.scene, g.display_file(), 5, 4, false).ids;
    EXPECT_EQ(std::ranges::count(seen, 1), std::ssize(seen));
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

/// Rounding decides whether the display file has a corner of the polygon that is on the window's
/// side, so distances are compared exactly; as those of pixels they would depend on the shape.
TEST(WorldTruth, TakesTheSameSupportPlaneInPicturesOfAnyShape) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  constexpr double kHeight = 1.0000000000000004e-06;
  g.set_window(0.0, 1.0, 0.0, kHeight);
  g.open_segment(1);
  g.polygon_abs_3({{-0.25, 5.5000000000000024e-07, 0.36467371214108413},
                   {-0.25, 7.0000000000000018e-07, 0.66897574968646811},
                   {0.25, -3e-07, 0.54224888701760066},
                   {0.0, 4.5000000000000014e-07, 0.60561231835203433},
                   {0.25, -1.4999999999999991e-07, 0.23794684947221667},
                   {0.75, kHeight, -1.4102902009235705}});
  constexpr double kDepth = 0.16132044233125886;
  g.polygon_abs_3({{-1, -kHeight, kDepth},
                   {2, -kHeight, kDepth},
                   {2, 2 * kHeight, kDepth},
                   {-1, 2 * kHeight, kDepth}});
  g.close_segment();
  ASSERT_EQ(retained.scene.size(), 2u) << "cut into triangles";
  constexpr int kWide = 16, kHigh = 8;
  const auto ids = [&](int height) {
    return world_truth(retained.scene, g.display_file(), kWide, height, false).ids;
  };
  const auto low = ids(kHigh), high = ids(3 * kHigh);  // its every third row is one of the low one
  for (int row = 0; row < kHigh; ++row) {
    const auto begin = [&](const auto& of, int from_top) { return of.begin() + from_top * kWide; };
    EXPECT_TRUE(std::equal(begin(low, row), begin(low, row + 1), begin(high, 3 * row + 1)))
        << "row " << row;
  }
  EXPECT_GT(std::ranges::count(low, 0), 4);
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
