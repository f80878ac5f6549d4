// What `auto` picks: always exact, and no more work than the scene needs.

#include "interp/visibility/auto_method.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/draw.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

DisplayFile file_of(const std::vector<test::Vertices>& polygons) {
  return test::file_of(polygons, {LineStyle::Kind::none});
}

test::Vertices square(double x, double y, double side, double z) {
  return {{x, y, z}, {x + side, y, z}, {x + side, y + side, z}, {x, y + side, z}};
}

TEST(AutoMethod, TilesBesideEachOtherNeedNoOrder) {
  std::vector<test::Vertices> tiles;
  for (int k = 0; k < 256; ++k) {
    tiles.push_back(square(k % 16 / 16.0, k / 16 / 16.0, 1 / 16.0, (k * 7 % 13) / 13.0));
  }
  const DisplayFile file = file_of(tiles);
  EXPECT_EQ(choose_method(file, PictureKind::vector).method, HiddenMethod::none);
}

/// The three sides seen of a cube: their boxes overlap, but none hides another.
TEST(AutoMethod, AConvexObjectWithoutBackFacesNeedsNoOrder) {
  const Point3 o(0.5, 0.5, 1), x(0.375, -0.25, -0.25), y(0, 0.375, -0.5), z(-0.375, -0.25, -0.25);
  const DisplayFile cube = file_of(
      {{o, o + x, o + x + y, o + y}, {o, o + y, o + y + z, o + z}, {o, o + z, o + z + x, o + x}});
  EXPECT_TRUE(nothing_hides(ViewedScene(cube)));
  EXPECT_EQ(choose_method(cube, PictureKind::vector).method, HiddenMethod::none);
}

TEST(AutoMethod, WhatOverlapsIsSorted) {
  const DisplayFile file = file_of({square(0.1, 0.1, 0.5, 0.9), square(0.3, 0.3, 0.5, 0.1)});
  EXPECT_EQ(choose_method(file, PictureKind::vector).method, HiddenMethod::depth_sort);
}

/// Where fills have the background's colour lines alone are seen, unless something is asked for
/// that only fills have.
TEST(AutoMethod, LinesOverFillsThatAreNotSeenAreLeftToAMethodOfLines) {
  GraphicsSystem g;
  g.open_segment(1);
  g.set_fill_style({FillStyle::Kind::solid, {1, 1, 1}});
  g.polygon_abs_3({{-0.5, -0.5, 0.5}, {0.5, -0.5, 0.5}, {0, 0.5, 0.5}});
  g.polygon_abs_3({{-0.5, 0.2, 0}, {0.5, 0.2, 0}, {0, -0.6, 0}});
  g.close_segment();
  const auto method = [&](const DrawOptions& options = {}, PictureKind kind = PictureKind::vector) {
    DrawOptions with_auto = options;
    with_auto.hidden = HiddenMethod::automatic;
    return drawing_method(g, with_auto, kind);
  };
  EXPECT_EQ(method(), HiddenMethod::franklin);
  EXPECT_EQ(method({}, PictureKind::raster), HiddenMethod::z_buffer);
  EXPECT_EQ(method({.background = Background{Background::Kind::none}}), HiddenMethod::depth_sort);
  EXPECT_EQ(method({.background = Background{Background::Kind::solid, {1, 1, 0}}}),
            HiddenMethod::depth_sort);
  EXPECT_EQ(method({.ids = "ids.npy"}), HiddenMethod::depth_sort);
  g.set_background({Background::Kind::solid, {0, 0, 1}});
  EXPECT_EQ(method(), HiddenMethod::depth_sort);
  g.set_background({});
  EXPECT_EQ(method(), HiddenMethod::franklin);
  g.open_segment(2);
  g.set_line_style({LineStyle::Kind::none});
  g.polygon_abs_3({{-0.9, -0.9, 0.1}, {-0.7, -0.9, 0.1}, {-0.8, -0.7, 0.1}});
  g.close_segment();
  EXPECT_EQ(method(), HiddenMethod::franklin);
  g.open_segment(3);
  g.set_fill_style({FillStyle::Kind::solid, {1, 0, 0}});
  g.polygon_abs_3({{-0.9, -0.9, 0.1}, {-0.7, -0.9, 0.1}, {-0.8, -0.7, 0.1}});
  g.close_segment();
  EXPECT_EQ(method(), HiddenMethod::depth_sort);  // that one is seen
  g.set_visibility(3, false);
  EXPECT_EQ(method(), HiddenMethod::franklin);
  g.set_visibility(1, false);
  EXPECT_EQ(method(), HiddenMethod::none);  // no line is drawn
}

/// How far that is from the best method of each scene, `displayfile bench` tells.
TEST(AutoMethod, PixelsAreLeftToTheZBuffer) {
  EXPECT_EQ(choose_method(DisplayFile(), PictureKind::raster).method, HiddenMethod::z_buffer);
  const DisplayFile file = file_of({square(0.1, 0.1, 0.5, 0.9), square(0.3, 0.3, 0.5, 0.1)});
  EXPECT_EQ(choose_method(file, PictureKind::raster).method, HiddenMethod::z_buffer);
}

TEST(AutoMethod, DrawsTheTruth) {
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      const DisplayFile file = test::scene(family, seed, 2 + static_cast<int>(seed % 7));
      SoftwareRenderer renderer;
      for (const int side : {24, 150}) {
        const RasterRequest request{
            .width = side, .height = side, .method = HiddenMethod::automatic, .ids = true};
        ASSERT_EQ(renderer.draw(file, request).ids, truth(file, side, side, false).ids)
            << family.name << ", seed " << seed << ", side " << side;
      }
    }
  }
}

/// Edges are drawn over the neighbours' insides.
TEST(AutoMethod, LinesAreHiddenByOrder) {
  DisplayFile file = file_of({square(0, 0, 0.5, 0.5), square(0.5, 0, 0.5, 0.5)});
  file.segment(1).set_style(LineStyle{});
  file.segment(1).enter_line({0, 0, 0}, {1, 1, 0});
  EXPECT_EQ(choose_method(file, PictureKind::vector).method, HiddenMethod::depth_sort);
}

/// Whatever is said to need no order is drawn right in the order of entry.
TEST(AutoMethod, NothingHidesOnlyWhereAnyOrderIsRight) {
  int claimed = 0;
  for (const test::SceneFamily& family : test::scene_families()) {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
      const DisplayFile file = test::scene(family, seed, 2 + static_cast<int>(seed % 3));
      if (!nothing_hides(ViewedScene(file))) continue;
      ++claimed;
      const RasterRequest request{.width = 32, .height = 32, .ids = true};
      ASSERT_EQ(draw_with_software(file, request).ids, truth(file, 32, 32, false).ids)
          << family.name << ", seed " << seed;
    }
  }
  EXPECT_GT(claimed, 50);
}

}  // namespace
}  // namespace displayfile
