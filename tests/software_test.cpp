#include "interp/raster/software.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "interp/device/raster_request.h"
#include "interp/scan/scan_convert.h"
#include "tests/truth_scenes.h"
#include "tests/unit_square.h"

namespace displayfile {
namespace {

using test::letters_of;
using test::unit_square_without_lines;

constexpr std::uint32_t kWhite = 0xFFFFFFFF;

RasterRequest request(int width, int height, bool z_buffer) {
  RasterRequest r;
  r.width = width;
  r.height = height;
  r.surfaces.method = z_buffer ? HiddenMethod::z_buffer : HiddenMethod::none;
  r.ids = r.depth = true;
  return r;
}

TEST(ScanConvert, CentresOnLeftAndTopEdgesBelong) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);  // from centre to centre of a 4 x 4 picture
  g.polygon_abs_2({{0.125, 0.125}, {0.625, 0.125}, {0.625, 0.625}, {0.125, 0.625}});
  g.close_segment();
  EXPECT_EQ(letters_of(draw_with_software(g.display_file(), request(4, 4, false))),
            "....\n"
            "aa..\n"
            "aa..\n"
            "....\n");
}

TEST(ScanConvert, EvenOddForConcaveAndSelfCrossingPolygons) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}, {0.5, 0.25}, {0, 1}});
  g.close_segment();
  EXPECT_EQ(letters_of(draw_with_software(g.display_file(), request(8, 4, false))),
            "a......a\n"
            "aa....aa\n"
            "aaa..aaa\n"
            "aaaaaaaa\n");
  GraphicsSystem h = unit_square_without_lines();
  h.open_segment(1);  // two squares, the inner one run through twice: a hole
  h.polygon_abs_2({{0, 0},
                   {1, 0},
                   {1, 1},
                   {0, 1},
                   {0, 0},
                   {0.25, 0.25},
                   {0.75, 0.25},
                   {0.75, 0.75},
                   {0.25, 0.75},
                   {0.25, 0.25}});
  h.close_segment();
  EXPECT_EQ(letters_of(draw_with_software(h.display_file(), request(4, 4, false))),
            "aaaa\n"
            "a..a\n"
            "a..a\n"
            "aaaa\n");
}

// Triangles that tile a square: each pixel is covered by exactly one, whatever the directions
// of their edges and however their vertices fall on pixel centres.
TEST(ScanConvert, TilesCoverEveryPixelExactlyOnce) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const int size = 16;
    std::uniform_int_distribution<int> grid(1, 2 * size - 1);
    const Point3 middle(grid(random) / 32.0, grid(random) / 32.0, 0);
    const std::vector<Point3> corner{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    std::vector<int> covered(size * size, 0);
    ScanConverter converter;
    for (int i = 0; i < 4; ++i) {
      const std::vector<Point3> t{corner[static_cast<std::size_t>(i)],
                                  corner[static_cast<std::size_t>(i + 1) % 4], middle};
      converter.scan_convert(t, {{size, size}, 0, size}, [&](int row, int first, int end) {
        for (int x = first; x < end; ++x) ++covered[static_cast<std::size_t>(row * size + x)];
      });
    }
    for (int c : covered) EXPECT_EQ(c, 1) << middle.x << ' ' << middle.y;
  }
}

TEST(ScanConvert, HugeAndOffPictureCoordinatesAreClippedToTheRegion) {
  ScanConverter converter;
  long covered = 0;
  const auto count = [&](int, int first, int end) { covered += end - first; };
  const std::vector<Point3> huge{
      {-1e99, -1e99, 0}, {1e99, -1e99, 0}, {1e99, 1e99, 0}, {-1e99, 1e99, 0}};
  converter.scan_convert(huge, {{10, 10}, 0, 10}, count);
  EXPECT_EQ(covered, 100);
  covered = 0;
  const std::vector<Point3> away{{2, 0, 0}, {3, 0, 0}, {3, 1, 0}};
  converter.scan_convert(away, {{10, 10}, 0, 10}, count);
  EXPECT_EQ(covered, 0);
}

TEST(ZBuffer, NearestIsSeenWhateverTheOrder) {
  for (bool near_first : {true, false}) {
    GraphicsSystem g = unit_square_without_lines();
    g.open_segment(1);
    const auto square = [&](double z, int id) {
      g.set_pick_id(id);
      g.polygon_abs_3({{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
    };
    if (near_first) square(0.75, 0);
    square(0.25, 1);
    if (!near_first) square(0.75, 0);
    g.close_segment();
    const Picture p = draw_with_software(g.display_file(), request(2, 2, true));
    EXPECT_EQ(letters_of(p), "aa\naa\n");
    EXPECT_EQ(p.depth, std::vector<double>(4, 0.75));
  }
}

TEST(ZBuffer, OfEqualDepthsTheOneEnteredLaterIsSeen) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}});
  g.polygon_abs_3({{0, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 1, 0.5}, {0, 1, 0.5}});
  g.close_segment();
  EXPECT_EQ(letters_of(draw_with_software(g.display_file(), request(4, 2, true))), "bbaa\nbbaa\n");
}

TEST(ZBuffer, InterpenetratingPlanesCrossWhereTheirDepthsAreEqual) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 0}});
  g.polygon_abs_3({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}});
  g.close_segment();
  EXPECT_EQ(letters_of(draw_with_software(g.display_file(), request(8, 1, true))), "bbbbaaaa\n");
}

TEST(ZBuffer, DepthIsThatOfThePlaneAtThePixelCentre) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_3({{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0.25}, {-0.5, 0.5, -0.125}});
  g.close_segment();
  const Picture p = draw_with_software(g.display_file(), request(4, 4, true));
  EXPECT_EQ(p.depth[12], 0.125 * 0.5 + 0.125 * 0.25);  // bottom left pixel
  EXPECT_EQ(p.depth[4], 0.125 * 0.5 + 0.625 * 0.25);
  EXPECT_EQ(p.depth[3], -std::numeric_limits<double>::infinity());
}

// Problem 10.8: the 2 x 2 display, with the book's depths turned to ours (z = 1 - the book's).
TEST(ZBuffer, Problem10_8) {
  GraphicsSystem g = unit_square_without_lines();
  const Colour a(1, 0, 0), b(0, 0, 1);
  g.set_hidden_surfaces({.z_buffer = true});
  g.open_segment(1);
  g.set_line_style({LineStyle::Kind::solid, a});
  g.move_abs_3(0.25, 0.25, 1);
  g.line_abs_3(1, 1, 1);
  g.close_segment();
  g.open_segment(2);
  g.set_line_style({LineStyle::Kind::none});
  g.set_fill_style({FillStyle::Kind::solid, b});
  g.polygon_abs_3({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}});
  g.close_segment();
  const std::uint32_t red = pixel_of(a), blue = pixel_of(b);
  const auto picture = [&] {
    return draw_with_software(g.display_file(), request(2, 2, true)).pixels;
  };
  using Pixels = std::vector<std::uint32_t>;
  EXPECT_EQ(picture(), (Pixels{blue, red, red, blue}));
  g.set_visibility(2, false);  // step 2: object A alone
  EXPECT_EQ(picture(), (Pixels{kWhite, red, red, kWhite}));
  g.set_visibility(1, false);
  g.set_visibility(2, true);
  EXPECT_EQ(picture(), (Pixels{blue, blue, blue, blue}));
}

TEST(ZBuffer, ALineWinsAtEqualDepthAndLosesBehind) {
  for (double z : {0.5, 0.25}) {
    GraphicsSystem g = unit_square_without_lines();
    g.open_segment(1);
    g.set_line_style({LineStyle::Kind::solid, {1, 0, 0}});
    g.move_abs_3(0, 0.5, z);
    g.line_abs_3(1, 0.5, z);
    g.set_line_style({LineStyle::Kind::none});
    g.polygon_abs_3({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}});
    g.close_segment();
    const Picture p = draw_with_software(g.display_file(), request(4, 4, true));
    const auto red = std::count(p.pixels.begin(), p.pixels.end(), pixel_of({1, 0, 0}));
    EXPECT_EQ(red, z == 0.5 ? 4 : 0);
    EXPECT_EQ(letters_of(p), "aaaa\naaaa\naaaa\naaaa\n");  // item buffers hold fills only
    EXPECT_EQ(p.depth, std::vector<double>(16, 0.5));
  }
}

TEST(ZBuffer, APolygonsOwnEdgesAreSeenWhole) {
  GraphicsSystem g = unit_square_without_lines();
  g.set_line_style({LineStyle::Kind::solid, {0, 0, 0}});
  g.open_segment(1);  // steep: half a pixel aside its plane is far nearer or farther
  g.polygon_abs_3({{0.1, 0.1, 0}, {0.9, 0.2, 1}, {0.5, 0.9, -3}});
  g.close_segment();
  GraphicsSystem h = unit_square_without_lines();
  h.set_line_style({LineStyle::Kind::solid, {0, 0, 0}});
  h.set_fill_style({FillStyle::Kind::hollow});
  h.open_segment(1);
  h.polygon_abs_3({{0.1, 0.1, 0}, {0.9, 0.2, 1}, {0.5, 0.9, -3}});
  h.close_segment();
  const auto black = [](const GraphicsSystem& s) {
    const Picture p = draw_with_software(s.display_file(), request(64, 64, true));
    std::vector<bool> is_black;
    for (auto pixel : p.pixels) is_black.push_back(pixel == 0xFF000000);
    return is_black;
  };
  EXPECT_EQ(black(g), black(h));
}

TEST(HollowPolygon, CoversNothing) {
  GraphicsSystem g = unit_square_without_lines();
  g.set_fill_style({FillStyle::Kind::hollow});
  g.open_segment(1);
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  g.close_segment();
  EXPECT_EQ(letters_of(draw_with_software(g.display_file(), request(2, 2, true))), "..\n..\n");
}

TEST(EdgeOnPolygon, CoversNothing) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_3({{0.5, 0, 0}, {0.5, 1, 0}, {0.5, 1, 1}, {0.5, 0, 1}});
  g.close_segment();
  EXPECT_EQ(letters_of(draw_with_software(g.display_file(), request(4, 1, true))), "....\n");
}

TEST(Lines, WidthAndDashes) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.set_line_style({LineStyle::Kind::solid, {0, 0, 0}, 3.0});
  g.move_abs_2(0, 0.5);
  g.line_abs_2(1, 0.5);
  g.close_segment();
  const auto dark = [&](int width, int height) {
    const Picture p = draw_with_software(g.display_file(), request(width, height, false));
    return std::count(p.pixels.begin(), p.pixels.end(), 0xFF000000u);
  };
  EXPECT_EQ(dark(20, 9), 60);
  g.delete_segment(1);
  g.open_segment(1);
  g.set_line_style({LineStyle::Kind::dashed, {0, 0, 0}, 1.0, 3.0, 2.0});
  g.move_abs_2(0, 0.5);
  g.line_abs_2(1, 0.5);
  g.close_segment();
  EXPECT_EQ(dark(20, 9), 12);
}

TEST(Lines, RunningFarOutOfThePictureAreClipped) {
  GraphicsSystem g = unit_square_without_lines();
  g.set_line_style({LineStyle::Kind::solid, {0, 0, 0}});
  g.open_segment(1);
  g.move_abs_2(0, 0.5);
  g.line_abs_2(1, 0.5);
  g.close_segment();
  g.set_image_scale(1, 1e90, 1);
  g.set_image_translation(1, -0.5e90, 0);
  const Picture p = draw_with_software(g.display_file(), request(20, 9, true));
  EXPECT_EQ(std::count(p.pixels.begin(), p.pixels.end(), 0xFF000000u), 20);
}

TEST(Segments, InvisibleOnesAreNotDrawn) {
  GraphicsSystem g = unit_square_without_lines();
  g.open_segment(1);
  g.polygon_abs_2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  g.close_segment();
  g.set_visibility(1, false);
  EXPECT_EQ(letters_of(draw_with_software(g.display_file(), request(2, 1, false))), "..\n");
}

TEST(Picture, SizesOutOfRangeAreErrors) {
  GraphicsSystem g;
  EXPECT_THROW(draw_with_software(g.display_file(), request(0, 0, true)), Error);
  EXPECT_THROW(draw_with_software(g.display_file(), request(1000000, 1000000, true)), Error);
  EXPECT_EQ(draw_with_software(g.display_file(), request(1, 1, true)).pixels.size(), 1u);
}

TEST(Threads, ThePictureIsTheSameForAnyNumber) {
  GraphicsSystem g;
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> u(-1, 1);
  g.open_segment(1);
  for (int i = 0; i < 300; ++i) {
    g.polygon_abs_3({{u(random), u(random), u(random)},
                     {u(random), u(random), u(random)},
                     {u(random), u(random), u(random)}});
    g.line_abs_3(u(random), u(random), u(random));
  }
  g.close_segment();
  for (bool z_buffer : {false, true}) {
    RasterRequest r = request(97, 61, z_buffer);
    const Picture one = draw_with_software(g.display_file(), r);
    for (int threads : {2, 3, 8, 100}) {
      r.surfaces.threads = threads;
      const Picture many = draw_with_software(g.display_file(), r);
      EXPECT_EQ(many.pixels, one.pixels);
      EXPECT_EQ(many.ids, one.ids);
      EXPECT_EQ(many.depth, one.depth);
    }
  }
}

}  // namespace
}  // namespace displayfile
