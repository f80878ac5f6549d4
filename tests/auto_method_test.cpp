// The choice of `auto`: always exact, and no more work than the scene needs.

#include "interp/visibility/auto_method.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
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

TEST(AutoMethod, VectorsAreTheMap) {
  const DisplayFile file = file_of({square(0.1, 0.1, 0.5, 0.9), square(0.3, 0.3, 0.5, 0.1)});
  EXPECT_EQ(choose_method(file, PictureKind::vector).method, HiddenMethod::map);
}

TEST(AutoMethod, VectorsWithoutFillsHideNothing) {
  DisplayFile file;
  file.create(1).set_style(LineStyle{});
  file.segment(1).enter_line({0, 0, 0}, {1, 1, 0});
  EXPECT_EQ(choose_method(file, PictureKind::vector).method, HiddenMethod::none);
}

/// Where fills have the background's colour, only lines are visible, unless an output is requested
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
    with_auto.surfaces.method = HiddenMethod::automatic;
    return drawing_method(g, with_auto, kind);
  };
  EXPECT_EQ(method(), HiddenMethod::franklin);
  EXPECT_EQ(method({}, PictureKind::raster), HiddenMethod::z_buffer);
  EXPECT_EQ(method({.background = Background{Background::Kind::none}}), HiddenMethod::map);
  EXPECT_EQ(method({.background = Background{Background::Kind::solid, {1, 1, 0}}}),
            HiddenMethod::map);
  EXPECT_EQ(method({.ids = "ids.npy"}), HiddenMethod::map);
  g.set_background({Background::Kind::solid, {0, 0, 1}});
  EXPECT_EQ(method(), HiddenMethod::map);
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
  EXPECT_EQ(method(), HiddenMethod::map);  // that one is seen
  g.set_visibility(3, false);
  EXPECT_EQ(method(), HiddenMethod::franklin);
  g.set_visibility(1, false);
  EXPECT_EQ(method(), HiddenMethod::map);  // no line is drawn
}

/// `displayfile bench` measures how far that is from the best method of each scene.
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
        const RasterRequest request{.width = side,
                                    .height = side,
                                    .surfaces = {.method = HiddenMethod::automatic},
                                    .ids = true};
        ASSERT_EQ(renderer.draw(file, request).ids, truth(file, side, side, false).ids)
            << family.name << ", seed " << seed << ", side " << side;
      }
    }
  }
}

/// Edges are drawn over the neighbours' insides.
TEST(AutoMethod, LinesAreHiddenByTheMap) {
  DisplayFile file = file_of({square(0, 0, 0.5, 0.5), square(0.5, 0, 0.5, 0.5)});
  file.segment(1).set_style(LineStyle{});
  file.segment(1).enter_line({0, 0, 0}, {1, 1, 0});
  EXPECT_EQ(choose_method(file, PictureKind::vector).method, HiddenMethod::map);
}

}  // namespace
}  // namespace displayfile
