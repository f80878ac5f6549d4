// Antialiasing as its users meet it: each pixel is the mean of its samples, whatever draws them.

#include "interp/raster/antialias.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "clip/base/error.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/draw/draw.h"
#include "interp/draw/picture_plan.h"
#include "interp/draw/turntable_renderer.h"
#include "tests/unit_square.h"

namespace displayfile {
namespace {

/// A system whose display coordinates are its world coordinates.
GraphicsSystem system_of(HiddenMethod method) {
  GraphicsSystem g = test::unit_square_without_lines();
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  g.set_hidden_surfaces({.method = method});
  return g;
}

DrawOptions options(int size, std::optional<int> samples) {
  DrawOptions o;
  o.width = o.height = size;
  o.samples = samples;
  return o;
}

constexpr std::array kMethods{HiddenMethod::none,        HiddenMethod::bsp,
                              HiddenMethod::depth_sort,  HiddenMethod::z_buffer,
                              HiddenMethod::scan_line_z, HiddenMethod::warnock};

TEST(Antialias, APixelHalfCoveredIsHalfAsDark) {
  for (const HiddenMethod method : kMethods) {
    GraphicsSystem g = system_of(method);
    g.set_fill_style({FillStyle::Kind::solid, {0, 0, 0}});
    g.open_segment(1);
    g.polygon_abs_3({{0, 0, -0.5}, {0.625, 0, -0.5}, {0.625, 1, -0.5}, {0, 1, -0.5}});
    g.close_segment();
    const Picture picture = draw(g, options(4, 4));
    ASSERT_EQ(picture.pixels.size(), 16u);
    for (std::size_t row = 0; row < 4; ++row) {
      EXPECT_EQ(picture.pixels[4 * row + 1], 0xFF000000u);
      EXPECT_EQ(picture.pixels[4 * row + 2], 0xFF808080u) << name_of(method);
      EXPECT_EQ(picture.pixels[4 * row + 3], 0xFFFFFFFFu);
    }
  }
}

/// The area under a slanted edge, to the precision of n x n samples.
TEST(Antialias, MeansComeCloserToTheAreaWithMoreSamples) {
  GraphicsSystem g = system_of(HiddenMethod::z_buffer);
  g.set_fill_style({FillStyle::Kind::solid, {0, 0, 0}});
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, -0.5}, {1, 0, -0.5}, {1, 0.37, -0.5}});
  g.close_segment();
  for (const int n : {2, 4, 8, 16}) {
    const Picture picture = draw(g, options(1, n));
    const double covered = 1.0 - (picture.pixels[0] & 0xFF) / 255.0;
    EXPECT_NEAR(covered, 0.185, 0.6 / n) << n;
  }
}

TEST(Antialias, ItemsAndDepthAreThoseOfOneSample) {
  GraphicsSystem g = system_of(HiddenMethod::z_buffer);
  g.open_segment(1);
  g.polygon_abs_3({{0.1, 0.1, -0.5}, {0.9, 0.2, -0.3}, {0.4, 0.95, -0.7}});
  g.close_segment();
  DrawOptions one = options(19, 1), nine = options(19, 3);
  one.ids = nine.ids = "ids.npy";
  one.depth = nine.depth = "depth.npy";
  const Picture a = draw(g, one), b = draw(g, nine);
  EXPECT_EQ(a.ids, b.ids);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_NE(a.pixels, b.pixels);
}

/// A line keeps its width in pixels, so the ink it takes.
TEST(Antialias, LinesKeepTheirWidth) {
  GraphicsSystem g = system_of(HiddenMethod::z_buffer);
  g.set_line_style({LineStyle::Kind::solid, {0, 0, 0}, 4.0});
  g.open_segment(1);
  g.move_abs_3(0, 0.5, -0.5);
  g.line_abs_3(1, 0.5, -0.5);
  g.close_segment();
  for (const int n : {1, 2, 5}) {
    const Picture picture = draw(g, options(32, n));
    double ink = 0.0;
    for (const std::uint32_t pixel : picture.pixels) ink += 1.0 - (pixel & 0xFF) / 255.0;
    EXPECT_NEAR(ink, 4.0 * 32, 0.02 * 4 * 32) << n;
  }
}

TEST(Antialias, RowsMayComeInAnyPortions) {
  Picture fine;
  fine.width = 6;
  fine.height = 9;
  for (std::uint32_t i = 0; i < 54; ++i) fine.pixels.push_back(0xFF000000u | i * 0x040201u);
  const auto averaged = [&](const std::vector<int>& portions) {
    std::vector<std::uint32_t> pixels;
    SampleAverage average(2, 3, [&](const Picture& rows) {
      pixels.insert(pixels.end(), rows.pixels.begin(), rows.pixels.end());
    });
    std::ptrdiff_t row = 0;
    for (const int n : portions) {
      Picture part;
      part.width = 6;
      part.height = n;
      part.pixels.assign(fine.pixels.begin() + 6 * row, fine.pixels.begin() + 6 * (row + n));
      average(part);
      row += n;
    }
    return pixels;
  };
  EXPECT_EQ(averaged({9}).size(), 6u);
  EXPECT_EQ(averaged({9}), averaged({1, 1, 1, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(averaged({9}), averaged({2, 5, 2}));
}

TEST(Antialias, TooManySamplesAreRefused) {
  const GraphicsSystem g = system_of(HiddenMethod::z_buffer);
  EXPECT_THROW(draw(g, options(8, 0)), Error);
  EXPECT_THROW(draw(g, options(8, 17)), Error);
  EXPECT_THROW(draw(g, options(65535, 2)), Error);
}

// ---- Where nothing is set ----------------------------------------------------------------

constexpr std::uint32_t kWhite = 0xFFFFFFFFu, kRed = 0xFF0000FFu;

/// A red triangle of slanted sides on white.
GraphicsSystem slanted(HiddenMethod method = HiddenMethod::z_buffer) {
  GraphicsSystem g = system_of(method);
  g.set_fill_style({FillStyle::Kind::solid, {1, 0, 0}});
  g.set_pick_id(7);
  g.open_segment(1);
  g.polygon_abs_3({{0.1, 0.1, -0.5}, {0.9, 0.2, -0.3}, {0.4, 0.95, -0.7}});
  g.close_segment();
  return g;
}

std::ptrdiff_t mixed_pixels(const Picture& picture) {
  return std::ranges::count_if(
      picture.pixels, [](std::uint32_t pixel) { return pixel != kWhite && pixel != kRed; });
}

TEST(UsualSamples, MixColoursAtEdgesAlone) {
  for (const HiddenMethod method : kMethods) {
    const GraphicsSystem g = slanted(method);
    const Picture usual = draw(g, options(40, std::nullopt));
    const Picture one = draw(g, options(40, 1));
    EXPECT_GT(mixed_pixels(usual), 40) << name_of(method);
    EXPECT_EQ(mixed_pixels(one), 0) << name_of(method);
    EXPECT_EQ(usual.pixels, draw(g, options(40, kUsualSamples)).pixels) << name_of(method);
    EXPECT_EQ(usual.pixels[20 * 40 + 18], kRed) << name_of(method);  // in the middle
    EXPECT_EQ(usual.pixels[0], kWhite) << name_of(method);
  }
}

TEST(UsualSamples, LeaveItemsAndDepthsAsTheyAre) {
  const GraphicsSystem g = slanted();
  DrawOptions usual = options(40, std::nullopt), one = options(40, 1);
  for (DrawOptions* const wanted : {&usual, &one}) wanted->with_ids = wanted->with_depth = true;
  const Picture a = draw(g, usual), b = draw(g, one);
  EXPECT_EQ(a.ids, b.ids);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_NE(a.pixels, b.pixels);
}

TEST(UsualSamples, AreThoseOfFilesAndViewsToo) {
  RetainedScene scene;
  GraphicsSystem g = test::unit_square_without_lines();
  g.retain(&scene);
  g.open_segment(1);
  g.polygon_abs_3({{0.1, 0.1, -0.5}, {0.9, 0.2, -0.3}, {0.4, 0.95, -0.7}});
  g.close_segment();
  const auto file = [&](std::optional<int> samples) {
    return draw_as(g, "ppm", options(30, samples));
  };
  EXPECT_EQ(file(std::nullopt), file(kUsualSamples));
  EXPECT_NE(file(std::nullopt), file(1));
  const auto view = [&](std::optional<int> samples) {
    const TurntableViews views{3};
    return TurntableRenderer(g, scene, g.display_file(), views, options(30, samples)).draw(1);
  };
  EXPECT_EQ(view(std::nullopt).pixels, view(kUsualSamples).pixels);
  EXPECT_NE(view(std::nullopt).pixels, view(1).pixels);
}

/// As many as fit, where four do not: no size is refused because of default samples.
TEST(UsualSamples, AreFewerInTheLargestPictures) {
  const auto samples = [](int width, int height) {
    return resolve(DrawOptions{.width = width, .height = height}).samples;
  };
  EXPECT_EQ(samples(kLargestSide / 4, kLargestSide / 4), 4);
  EXPECT_EQ(samples(kLargestSide / 4 + 1, 9), 3);
  EXPECT_EQ(samples(9, kLargestSide / 3 + 1), 2);
  EXPECT_EQ(samples(kLargestSide / 2 + 1, 9), 1);
  EXPECT_EQ(samples(kLargestSide, kLargestSide), 1);
  const Picture row = draw(slanted(), DrawOptions{.width = kLargestSide,
                                                  .height = kLargestSide,
                                                  .rows = PictureRows{30000, 30001}});
  EXPECT_EQ(row.pixels.size(), static_cast<std::size_t>(kLargestSide));
  EXPECT_EQ(mixed_pixels(row), 0);
}

/// Where all samples would be in memory, each with its depth.
TEST(UsualSamples, AreOneWhereAPictureIsHeldWhole) {
  const Destination vectors("picture.svg"), pixels("picture.ppm");
  EXPECT_EQ(resolve(DrawOptions{}).samples, kUsualSamples);
  EXPECT_EQ(resolve(DrawOptions{}, &pixels).samples, kUsualSamples);
  EXPECT_EQ(resolve(DrawOptions{}, &vectors).samples, 1);
  EXPECT_EQ(resolve(DrawOptions{.device = "osmesa"}).samples, 1);
  EXPECT_EQ(resolve(DrawOptions{.device = "osmesa", .samples = 2}).samples, 2);
  for (const HiddenMethod method :
       {HiddenMethod::plain_z_buffer, HiddenMethod::plain_z_buffer_double,
        colour_rule_by(HiddenMethod::plain_z_buffer_16)}) {
    EXPECT_EQ(resolve(DrawOptions{.surfaces = {.method = method}}).samples, 1) << name_of(method);
    EXPECT_EQ(resolve(DrawOptions{.surfaces = {.method = method}, .samples = 3}).samples, 3)
        << name_of(method);
  }
}

}  // namespace
}  // namespace displayfile
