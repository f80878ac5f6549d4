// Texts in pictures. The shapes of letters depend on the fonts: tests check the places and colours
// of ink.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/software.h"
#include "interp/text/seen_texts.h"
#include "tests/replayed.h"
#include "tests/text_scenes.h"

namespace displayfile {
namespace {

using namespace test;

struct Box {
  int left, right, bottom, top;  ///< pixels, from the bottom; the last two beyond it
};

/// Where the two pictures differ; none where they do not.
std::optional<Box> difference(const Picture& a, const Picture& b) {
  std::optional<Box> box;
  for (int j = 0; j < a.height; ++j) {
    for (int i = 0; i < a.width; ++i) {
      const auto at = static_cast<std::size_t>((a.height - 1 - j) * a.width + i);
      if (a.pixels[at] == b.pixels[at]) continue;
      if (!box) box = Box{i, i + 1, j, j + 1};
      *box = {std::min(box->left, i), std::max(box->right, i + 1), std::min(box->bottom, j),
              std::max(box->top, j + 1)};
    }
  }
  return box;
}

Picture picture_of(std::string_view program, DrawOptions options = {.samples = 1}) {
  options.width = 320;
  options.height = 200;
  return draw(replayed(program), options);
}

/// The ink of texts in the scene.
std::optional<Box> ink(std::string_view texts, const DrawOptions& options = {.samples = 1},
                       std::string_view before = "") {
  return difference(picture_of(scene_with(texts, before), options),
                    picture_of(scene_with("", before), options));
}

/// Letters stand on their base line, at the side of the anchor that the style sets, about as wide
/// and as high as their size, in the line style's colour; nothing else changes.
TEST(Text, InkStandsAtItsAnchor) {
  for (const auto& [word, from, to] :
       {std::tuple{"left", 0.0, 1.0}, {"centre", -0.5, 0.5}, {"right", -1.0, 0.0}}) {
    SCOPED_TRACE(word);
    const std::string texts =
        fmt::format("move-abs-3 .5 .5 0\nset-text-style .25 {}\ntext \"HHHH\"\n", word);
    const auto box = ink(texts);
    ASSERT_TRUE(box);
    const double width = box->right - box->left, size = 0.25 * 200;
    EXPECT_GT(width, 1.6 * size);
    EXPECT_LT(width, 5.0 * size);
    EXPECT_NEAR(box->left, 160 + from * width, 0.25 * size);
    EXPECT_NEAR(box->right, 160 + to * width, 0.25 * size);
    EXPECT_NEAR(box->bottom, 100, 2);
    EXPECT_GT(box->top, 100 + 0.5 * size);
    EXPECT_LT(box->top, 100 + size);
    EXPECT_GT(std::ranges::count(picture_of(scene_with(texts)).pixels, pixel_of({0, 0.2, 1})),
              std::ranges::count(picture_of(scene_with("")).pixels, pixel_of({0, 0.2, 1})) + 200);
  }
}

/// Without a background the picture, composited over white, is that over white, up to rounding:
/// once in a component's steps, and a pixel of samples twice.
TEST(Text, IsSeenOnTransparentGround) {
  const std::string program =
      "set-background none\n" + scene_with(
                                    "set-text-style .25\nmove-abs-3 .02 .5 0\n"
                                    "text \"HHHH\"\nset-line-style solid 1 0 0\n"
                                    "move-abs-3 .04 .45 0\ntext \"OO\"\n");
  for (const int samples : {1, 4}) {
    DrawOptions options{.samples = 1};
    options.samples = samples;
    const Picture clear = picture_of(program, options);
    options.background = Background{};
    const Picture white = picture_of(program, options);
    std::size_t partly = 0;
    for (std::size_t i = 0; i < clear.pixels.size(); ++i) {
      const int alpha = static_cast<int>(clear.pixels[i] >> 24);
      partly += alpha > 0 && alpha < 255 ? 1 : 0;
      for (int shift = 0; shift < 24; shift += 8) {
        const int colour = static_cast<int>(clear.pixels[i] >> shift & 0xFF);
        const int on_white = (alpha * colour + (255 - alpha) * 255 + 127) / 255;
        ASSERT_NEAR(on_white, static_cast<int>(white.pixels[i] >> shift & 0xFF), samples)
            << samples << " samples, pixel " << i;
      }
    }
    EXPECT_GT(partly, 50u);
  }
}

TEST(Text, IsBlackInLineStyleNone) {
  const Picture picture = picture_of(
      scene_with("set-line-style none\nmove-abs-3 .2 .3 0\nset-text-style .5\ntext \"H\"\n"));
  EXPECT_GT(std::ranges::count(picture.pixels, 0xFF000000u), 100);
}

TEST(Text, BlanksAndNothingLeaveNoInk) {
  EXPECT_FALSE(ink("move-abs-3 .5 .5 0\ntext \"   \"\ntext \"\"\n"));
}

TEST(Text, AnchorsOutsideOfTheViewVolumeAreNotDrawn) {
  for (const char* at : {"-.01 .5 0", ".5 1.01 0", "1.01 .5 0", ".5 -.01 0"}) {
    EXPECT_FALSE(
        ink(fmt::format("move-abs-3 {}\nset-text-style .2 centre always\ntext \"HH\"\n", at)))
        << at;
  }
  const std::string_view clipped =
      "set-view-depth -1 1\nset-front-plane-clipping on\nset-back-plane-clipping on\n";
  EXPECT_TRUE(ink("move-abs-3 .5 .5 .5\ntext \"HH\"\n", {}, clipped));
  EXPECT_FALSE(ink("move-abs-3 .5 .5 1.5\ntext \"HH\"\n", {}, clipped));
  EXPECT_TRUE(ink("move-abs-3 0 .5 0\ntext \"HH\"\n"));  // on the border
  // In perspective, an anchor behind the eye.
  EXPECT_FALSE(ink("move-abs-3 .5 .5 9\nset-text-style .2 centre always\ntext \"HH\"\n", {},
                   "set-perspective .5 .5 4\n"));
}

/// By every method a text is visible where its anchor is: on the surface, its corner, its side,
/// before it; beside it; and always if its style says so.
TEST(Text, IsSeenWhereItsAnchorIs) {
  for (const HiddenMethod method : methods_that_remove()) {
    SCOPED_TRACE(name_of(method));
    DrawOptions options{.samples = 1};
    options.surfaces.method = method;
    const auto drawn = [&](std::string_view at, std::string_view style = "") {
      return ink(fmt::format("move-abs-3 {}\n{}\ntext \"HH\"\n", at, style), options).has_value();
    };
    EXPECT_TRUE(drawn(".125 .125 0"));
    EXPECT_TRUE(drawn(".875 .875 0"));
    EXPECT_TRUE(drawn(".3 .125 0"));
    EXPECT_TRUE(drawn(".3 .7 0"));
    EXPECT_TRUE(drawn(".3 .7 1"));
    EXPECT_TRUE(drawn(".05 .7 -1"));
    EXPECT_TRUE(drawn(".3 .125 -1"));  // behind the outline
    EXPECT_FALSE(drawn(".3 .7 -1"));
    EXPECT_FALSE(drawn(".3 .7 -.0001"));
    EXPECT_TRUE(drawn(".3 .7 -1", "set-text-style .03 always"));
  }
  DrawOptions not_removed{.samples = 1};
  not_removed.surfaces.method = HiddenMethod::none;
  EXPECT_TRUE(ink("move-abs-3 .3 .7 -1\ntext \"HH\"\n", not_removed));
  EXPECT_TRUE(ink("move-abs-3 .3 .7 -1\ntext \"HH\"\n", {}, "").has_value() == false);
}

/// A segment that is sorted by itself, as the textbook has it, hides only its own texts, as it
/// hides only its own lines; and one drawn by depth is no segment's.
TEST(Text, IsHiddenByWhatItIsSortedWith) {
  const auto program = [](std::string_view scope, bool text) {
    return fmt::format(
        "{}close-segment\nset-hidden-scope {}\nset-hidden-method bsp\n"
        "open-segment 2\npolygon-abs-3 0 0 0  .1 0 0  .1 .1 0\n"
        "move-abs-3 .5 .5 -1\n{}close-segment\n",
        kScene, scope, text ? "text \"HH\"\n" : "");
  };
  const auto drawn = [&](std::string_view scope, std::optional<HiddenMethod> method) {
    DrawOptions options{.samples = 1};
    options.surfaces.method = method;
    return difference(picture_of(program(scope, true), options),
                      picture_of(program(scope, false), options))
        .has_value();
  };
  EXPECT_TRUE(drawn("segment", std::nullopt));
  EXPECT_FALSE(drawn("all", std::nullopt));
  EXPECT_FALSE(drawn("segment", HiddenMethod::z_buffer));
}

/// Corners of polygons in many views: viewing rounds the anchor as it rounds the vertex, whether
/// the polygon is a triangle, flat, or flat within the tolerance.
TEST(Text, CornersAndPointsOfASurfaceAreSeenInAnyView) {
  const std::vector<Point3> corners{
      {-0.3, -0.4, 0.1}, {0.5, -0.35, -0.2}, {0.45, 0.4, -0.1}, {-0.35, 0.35, 0.2000001}};
  for (int k = 0; k < 200; ++k) {
    GraphicsSystem g;
    if (k % 2 == 0) g.set_perspective({0.3, -0.2, 5.1});
    g.rotate_x_3(k * 1.7);
    g.rotate_y_3(k * 0.7);
    g.open_segment(1);
    std::vector<Point3> plane{corners[0], corners[1], corners[2],
                              corners[0] + corners[2] - corners[1]};
    plane.resize(k % 3 == 0 ? 3 : 4);
    g.polygon_abs_3(plane);
    std::vector<Point3> anchors = plane;
    for (const auto& [s, t] : {std::pair{0.5, 0.5}, {0.25, 0.5}, {1.0 / 3, 0.1}, {0.0, 0.7}}) {
      anchors.push_back(corners[1] + s * (corners[0] - corners[1]) + t * (corners[2] - corners[1]));
    }
    for (const Point3& p : anchors) {
      g.move_abs_3(p.x, p.y, p.z);
      g.text("a");
    }
    g.close_segment();
    EXPECT_EQ(seen_texts(g.display_file(), true).size(), anchors.size()) << "view " << k;
  }
}

Picture joined_rows(const DisplayFile& file, const RasterRequest& request) {
  Picture all;
  all.width = request.width;
  SoftwareRenderer().draw(file, request, [&](const Picture& rows) {
    all.height += rows.height;
    all.pixels.insert(all.pixels.end(), rows.pixels.begin(), rows.pixels.end());
  });
  return all;
}

/// The picture is the same row by row, and by any number of threads; identifiers and depths do not
/// depend on texts.
TEST(Text, SamePixelsHoweverTheyAreDrawnAndOnAnyThreads) {
  const std::string texts =
      "set-text-style .4 centre\nmove-abs-3 .5 .37 0\ntext \"H\u00e9g\"\n"
      "set-text-style .05 left\nmove-abs-3 .2 .7777 0\ntext \"small, on several strips\"\n";
  const GraphicsSystem g = replayed(scene_with(texts)), plain = replayed(scene_with(""));
  for (const HiddenMethod method :
       {HiddenMethod::none, HiddenMethod::z_buffer, HiddenMethod::scan_line_z}) {
    RasterRequest request;
    request.width = 1301;
    request.height = 2003;
    request.surfaces.method = method;
    request.ids = request.depth = true;
    const Picture whole = draw_with_software(g.display_file(), request);
    EXPECT_TRUE(joined_rows(g.display_file(), request).pixels == whole.pixels);
    request.surfaces.threads = 3;
    EXPECT_TRUE(draw_with_software(g.display_file(), request).pixels == whole.pixels);
    const Picture without = draw_with_software(plain.display_file(), request);
    EXPECT_TRUE(whole.ids == without.ids);
    EXPECT_TRUE(whole.depth == without.depth);
    EXPECT_FALSE(whole.pixels == without.pixels);
  }
}

TEST(Text, IsAsLargeWithSamples) {
  const std::string_view texts = "move-abs-3 .25 .5 0\nset-text-style .25\ntext \"HHH\"\n";
  DrawOptions antialiased;
  antialiased.samples = 4;
  const auto one = ink(texts), many = ink(texts, antialiased);
  ASSERT_TRUE(one && many);
  EXPECT_NEAR(one->left, many->left, 1);
  EXPECT_NEAR(one->right, many->right, 1);
  EXPECT_NEAR(one->bottom, many->bottom, 1);
  EXPECT_NEAR(one->top, many->top, 1);
}

/// A renderer that is used again sees texts come and go.
TEST(Text, RendererUsedAgain) {
  SoftwareRenderer renderer;
  RasterRequest request;
  request.width = request.height = 200;
  request.surfaces.method = HiddenMethod::z_buffer;
  GraphicsSystem g = replayed(scene_with(""));
  const auto before = renderer.draw(g.display_file(), request).pixels;
  g.open_segment(2);
  g.move_abs_3(0.5, 0.5, 0);
  g.text("HH");
  g.close_segment();
  const auto with = renderer.draw(g.display_file(), request).pixels;
  EXPECT_FALSE(with == before);
  EXPECT_TRUE(renderer.draw(g.display_file(), request).pixels == with);
  g.set_image_translation(2, 0.1, 0);
  EXPECT_FALSE(renderer.draw(g.display_file(), request).pixels == with);
  g.set_visibility(2, false);
  EXPECT_TRUE(renderer.draw(g.display_file(), request).pixels == before);
}

TEST(Text, ByOsmesa) {
  if (!osmesa_available()) GTEST_SKIP() << osmesa_description();
  DrawOptions options{.samples = 1};
  options.device = "osmesa";
  for (const HiddenMethod method :
       {HiddenMethod::none, HiddenMethod::z_buffer, HiddenMethod::bsp}) {
    options.surfaces.method = method;
    const auto box = ink("move-abs-3 .5 .5 0\nset-text-style .25\ntext \"HH\"\n", options);
    ASSERT_TRUE(box);
    EXPECT_NEAR(box->left, 160, 13);
    EXPECT_NEAR(box->bottom, 100, 2);
    EXPECT_EQ(ink("move-abs-3 .5 .5 -1\ntext \"HH\"\n", options).has_value(),
              method == HiddenMethod::none);
  }
}

/// An image transformation may put an anchor anywhere.
TEST(Text, AnchorsFarOffThePicture) {
  for (const char* far : {"1e90 0", "-3 0", "0 1e9", "-1e90 -1e90"}) {
    const std::string program = fmt::format(
        "open-segment 1\nset-text-style 1\ntext \"H\"\nclose-segment\nset-image-translation 1 "
        "{}\n",
        far);
    const Picture picture = picture_of(program);
    EXPECT_EQ(std::ranges::count(picture.pixels, 0xFFFFFFFFu), 320 * 200) << far;
  }
}

}  // namespace
}  // namespace displayfile
