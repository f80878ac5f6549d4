// SVG and PDF files, drawn by somebody else, show the picture that the z-buffer shows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/raster/software.h"
#include "interp/vector/pdf_device.h"
#include "interp/vector/svg_device.h"
#include "tests/rasterised.h"
#include "tests/replayed.h"
#include "tests/shaded_scenes.h"
#include "tests/temporary_folder.h"
#include "tests/unit_square.h"
#include "tests/vector_scenes.h"

namespace displayfile {
namespace {

namespace fs = std::filesystem;
using namespace test;

/// Runs with each format for which there is a program that draws it.
class Rasterised : public TemporaryFolder, public testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    const std::string tool = rasteriser(GetParam());
    if (!have(tool)) GTEST_SKIP() << tool << " is not installed";
  }
  bool svg_format() const { return std::string(GetParam()) == "svg"; }
  Picture draw(const GraphicsSystem& g, int width, int height, bool by_map) const {
    const fs::path path = file(std::string("a.") + GetParam());
    DrawOptions options{.samples = 1};
    options.width = width;
    options.height = height;
    if (by_map) options.surfaces.method = HiddenMethod::map;
    displayfile::draw(g, path, options);
    const Picture picture = rasterised(path);
    EXPECT_EQ(picture.width, width);
    EXPECT_EQ(picture.height, height);
    return picture;
  }
};
INSTANTIATE_TEST_SUITE_P(Vector, Rasterised, testing::Values("svg", "pdf"),
                         [](const auto& format) { return std::string(format.param); });

int channel_difference(std::uint32_t a, std::uint32_t b) {
  int largest = 0;
  for (unsigned shift = 0; shift < 24; shift += 8) {
    largest = std::max(largest, std::abs(static_cast<int>((a >> shift) & 255) -
                                         static_cast<int>((b >> shift) & 255)));
  }
  return largest;
}

/// Compares where the z-buffer's picture has one colour two pixels around: neither antialiasing nor
/// the lines that close seams reach there. Returns the number of compared pixels. Polygons thinner
/// than a pixel may lie there without being in the z-buffer's picture; a scene that has them allows
/// some.
int expect_the_z_buffers_colours(const GraphicsSystem& g, const Picture& picture, int allowed = 0) {
  RasterRequest request;
  request.width = picture.width;
  request.height = picture.height;
  request.surfaces.method = HiddenMethod::z_buffer;
  const Picture expected = draw_with_software(g.display_file(), request);
  int compared = 0, wrong = 0;
  for (int y = 2; y < picture.height - 2; ++y) {
    for (int x = 2; x < picture.width - 2; ++x) {
      const auto pixel = [&](int dx, int dy) {
        return expected.pixels[static_cast<std::size_t>((y + dy) * picture.width + x + dx)];
      };
      bool flat = true;
      for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) flat = flat && pixel(dx, dy) == pixel(0, 0);
      }
      if (!flat) continue;
      ++compared;
      const auto here = picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
      wrong += channel_difference(here, pixel(0, 0)) > 1 ? 1 : 0;
    }
  }
  EXPECT_LE(wrong, allowed);
  return compared;
}

TEST_P(Rasterised, ColoursAndPlacesAreRight) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.set_fill_style(solid({1.0, 0.5, 0.0}));
  g.polygon_abs_2({{0, 0}, {.5, 0}, {.5, .5}, {0, .5}});
  g.set_fill_style(solid(kBlue));
  g.polygon_abs_2({{.6, .6},
                   {.9, .6},
                   {.9, .9},
                   {.6, .9},
                   {.6, .6},
                   {.7, .7},
                   {.7, .8},
                   {.8, .8},
                   {.8, .7},
                   {.7, .7}});  // a hole, even-odd
  g.set_line_style(line(kRed, 4.0));
  g.move_abs_2(0, .55);
  g.line_abs_2(1, .55);
  g.close_segment();
  const Picture p = draw(g, 200, 100, false);
  EXPECT_EQ(at(p, .25, .25), 0xff0080ffu);
  EXPECT_EQ(at(p, .01, .01), 0xff0080ffu);
  EXPECT_EQ(at(p, .65, .75), 0xffff0000u);
  EXPECT_EQ(at(p, .75, .75), 0xffffffffu);
  EXPECT_EQ(at(p, .5, .545), 0xff0000ffu);
  EXPECT_EQ(at(p, .5, .6), 0xffffffffu);
}

TEST_P(Rasterised, InterpenetratingTriangles) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  enter(g, 0xff0000, {{.1, .1, .2}, {.9, .1, .8}, {.5, .9, .5}});  // z grows with x
  enter(g, 0x0000ff, {{.1, .1, .8}, {.9, .1, .2}, {.5, .9, .5}});  // z falls with x
  g.close_segment();
  const Picture p = draw(g, 200, 200, true);
  EXPECT_EQ(at(p, .55, .3), 0xff0000ffu);  // red in memory order
  EXPECT_EQ(at(p, .45, .3), 0xffff0000u);
  EXPECT_GT(expect_the_z_buffers_colours(g, p), 30'000);
}

TEST_P(Rasterised, CyclicOverlap) {
  const GraphicsSystem g = cyclic_overlap();
  EXPECT_GT(expect_the_z_buffers_colours(g, draw(g, 200, 200, true)), 20'000);
}

TEST_P(Rasterised, Cube) {
  GraphicsSystem g = unit_square_without_lines();
  enter_cube(g);
  EXPECT_GT(expect_the_z_buffers_colours(g, draw(g, 200, 200, true)), 30'000);
}

TEST_P(Rasterised, ManyInterpenetratingPolygons) {
  GraphicsSystem g = unit_square_without_lines();
  enter_random(g, 11, 30, 0.6, 4);
  EXPECT_GT(expect_the_z_buffers_colours(g, draw(g, 300, 300, true), 40), 50'000);
}

/// As the z-buffer shades, where the pixels around show the same triangle. Poppler takes a gradient
/// at a pixel's corner: off by no more than the next pixel is.
TEST_P(Rasterised, GouraudShading) {
  GraphicsSystem g;
  g.set_view_depth(-2, 2);
  enter(triangles(2, 30), Shading::gouraud, g);
  RasterRequest request{.width = 300, .height = 300, .ids = true};
  request.surfaces.method = HiddenMethod::z_buffer;
  const Picture expected = draw_with_software(g.display_file(), request);
  const Picture p = draw(g, 300, 300, true);
  int compared = 0, wrong = 0;
  for (int y = 2; y < 298; ++y) {
    for (int x = 2; x < 298; ++x) {
      const auto place = [&](int dx, int dy) {
        return static_cast<std::size_t>((y + dy) * 300 + x + dx);
      };
      bool one = expected.ids[place(0, 0)] >= 0;
      for (int k = 0; k < 25; ++k) {
        one = one && expected.ids[place(k / 5 - 2, k % 5 - 2)] == expected.ids[place(0, 0)];
      }
      if (!one) continue;
      ++compared;
      const std::uint32_t colour = expected.pixels[place(0, 0)];
      int allowed = 2;
      for (int k = 0; k < 9 && !svg_format(); ++k) {
        const std::uint32_t next = expected.pixels[place(k / 3 - 1, k % 3 - 1)];
        allowed = std::max(allowed, 2 + channel_difference(next, colour));
      }
      wrong += channel_difference(p.pixels[place(0, 0)], colour) > allowed ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 20'000);
  EXPECT_LE(wrong, 40);  // as of ManyInterpenetratingPolygons
}

/// A program, and a pixel of 40 x 40 that shows its background.
struct ProgramAndPixel {
  const char* program;
  int column, row;
};

/// Needles, and polygons seen from the side, of which rounding leaves lines on the background.
TEST_P(Rasterised, BesideALineThatRoundingLeavesIsTheBackground) {
  const ProgramAndPixel needles{R"(
      set-window 0 1 0 1
      set-line-style none
      open-segment 1
      polygon-abs-3 0.25 0.5 0  0.25 0.25 0  0 1 0
      set-fill-style solid 0.63 0.75 0.3
      polygon-abs-3 0.5 0.75 1  0.25 0.25 0.75  0.37500000000000006 0.49999999999999994 1
      polygon-abs-3 0.5 0.75 0.75  0 0.75 0.5  0.25000000000000006 0.7499999999999999 1
      polygon-abs-3 1 0.75 0.75  0 0.25 0.25  0.5000000000000001 0.49999999999999994 0
      close-segment)",
                                17, 9};
  const ProgramAndPixel from_the_side{R"(
      set-perspective 0.5 0.5 0.5
      set-view-plane-normal -1 0 -1
      set-view-depth 0 1
      set-back-plane-clipping on
      set-line-style none
      open-segment 1
      polygon-abs-3 0.5 -0.5 1  0.5 -1 -2  -2 1 0.5
      polygon-abs-3 0.5 0.5 0  0 0.5 0  -0.5 0.5 0  0.5 0.5 1  -2 0.5 0.25  -1.5 0.5 0.25)"
                                      R"(  -0.5 0.5 1.5  -1.5 0.5 -2  0.25 0.5 1
      close-segment
      open-segment 2
      set-fill-style solid 0.9 0.6 0.825
      box-3 0.25 1.5 -1 0.5 0.25 1
      close-segment)",
                                      16, 9};
  for (const auto& [program, column, row] : {needles, from_the_side}) {
    const Picture p = draw(replayed(program), 40, 40, true);
    EXPECT_EQ(at(p, (column + 0.5) / 40, 1 - (row + 0.5) / 40), 0xffffffffu);
  }
}

/// A polygon that crosses itself and is seen as a line, and the shadow that it throws.
TEST_P(Rasterised, TheShadowOfAPolygonSeenEdgeOn) {
  const GraphicsSystem g = replayed(R"(
      set-view-plane-normal 1.0 0 0
      set-view-up 0 1 0
      set-perspective -4.256465140655326 0.0 0.0
      set-view-depth -1.0 4.0
      set-hidden-scope all
      set-line-style none
      set-light 1 2 3
      set-shadows on
      open-segment 1
      polygon-abs-3 -1 -1 -0.75  0 1 -0.75  -0.352 -0.584 0.91
      polygon-abs-3 -1 0 0.0  0 -0.5 -0.1  0.5 -0.5 -0.1  0 0.5 0.1  -1 0.5 0.1  -1 -0.5 -0.1
      close-segment)");
  // The rounded width leaves a needle, which poppler paints.
  EXPECT_GT(expect_the_z_buffers_colours(g, draw(g, 60, 60, true), svg_format() ? 0 : 20), 2'000);
}

TEST_P(Rasterised, NoSeamsBetweenNeighbours) {
  // Black triangles around a point: of 30 edges in all directions none may show the white
  // background. Without the lines that close the seams, a quarter of it would shine through.
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.set_fill_style(solid(kBlack));
  constexpr int kTriangles = 30;
  const auto rim = [](int k) {
    const double angle = 0.1 + 2.0 * 3.14159265358979 * k / kTriangles;
    return Point3(.503 + .45 * std::cos(angle), .501 + .45 * std::sin(angle), .5);
  };
  for (int k = 0; k < kTriangles; ++k) {
    g.polygon_abs_3({{.503, .501, .5}, rim(k), rim(k + 1)});
  }
  g.close_segment();
  for (const bool by_map : {false, true}) {
    const Picture p = draw(g, 200, 200, by_map);
    int lightest = 0;
    for (int y = 0; y < p.height; ++y) {
      for (int x = 0; x < p.width; ++x) {
        const double dx = (x + .5) / 200 - .503, dy = 1.0 - (y + .5) / 200 - .501;
        if (std::hypot(dx, dy) > .43) continue;
        const auto pixel = p.pixels[static_cast<std::size_t>(y * p.width + x)];
        lightest = std::max(lightest, static_cast<int>(pixel & 255));
      }
    }
    EXPECT_LE(lightest, 10);
  }
}

TEST_P(Rasterised, FarCoordinates) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.set_fill_style(solid(kGreen));
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}});  // its long side runs through the picture's corners
  g.close_segment();
  g.set_image_scale(1, 1e12, 1e12);
  for (const bool by_map : {false, true}) {
    const Picture p = draw(g, 100, 100, by_map);
    EXPECT_EQ(at(p, .7, .3), 0xff00ff00u);
    EXPECT_EQ(at(p, .3, .7), 0xffffffffu);
  }
}

}  // namespace
}  // namespace displayfile
