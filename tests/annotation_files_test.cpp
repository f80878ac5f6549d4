// Annotation in pictures of every format.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "interp/draw/draw.h"
#include "interp/draw/renderer.h"
#include "interp/opengl/osmesa.h"
#include "interp/vector/pens/stroke_letters.h"
#include "tests/replayed.h"
#include "tests/temporary_folder.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using namespace test;

/// A grey square before everything, a red dimension and a balloon behind it.
constexpr std::string_view kScene =
    "open-segment 3\nset-line-style none\nset-fill-style solid 0.5 0.5 0.5\n"
    "polygon-abs-3 -.5 -.5 1  .5 -.5 1  .5 .5 1  -.5 .5 1\n"
    "set-line-style solid 1 0 0\nset-annotation-size 10 px\n"
    "linear-dimension-3 y -.5 -.5 0  -.5 .5 0  -.25 0 0\n"
    "balloon-3 0 0 -.5 7 \"\" 60 40\nclose-segment\n";

std::uint32_t pixel_at_place(const Picture& picture, int x, int y) {
  return picture.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                        static_cast<std::size_t>(x)];
}

std::size_t red_pixels(const Picture& picture) {
  return static_cast<std::size_t>(std::ranges::count_if(picture.pixels, [](std::uint32_t p) {
    return (p & 0xFFu) > 200u && (p >> 8 & 0xFFu) < 60u;
  }));
}

TEST(AnnotationFiles, SvgHasItAfterAllElse) {
  const std::string svg = without_keys(draw_as(replayed(kScene), "svg"));
  const std::string_view part = std::string_view(svg).substr(svg.rfind("<g id"));
  EXPECT_TRUE(
      part.starts_with("<g id=\"segment-3-2\" class=\"segment\">\n<path class=\"l1\" d=\"M"))
      << svg;
  EXPECT_NE(part.find(" transform=\"rotate(-90 60 256)\">1</text>"), part.npos) << part;
  EXPECT_NE(part.find(">7</text>"), part.npos);
  EXPECT_NE(svg.find("stroke:#ff0000;stroke-width:0.7142857142857143"), svg.npos) << svg;
}

/// Every method of pixels draws it over the figure, and the rows of a picture alone are the same.
TEST(AnnotationFiles, PixelsOfEveryMethod) {
  const GraphicsSystem g = replayed(kScene);
  for (const HiddenMethod method :
       {HiddenMethod::none, HiddenMethod::z_buffer, HiddenMethod::bsp, HiddenMethod::map}) {
    DrawOptions options{.samples = 1};
    options.surfaces.method = method;
    const Picture picture = draw(g, options);
    EXPECT_EQ(pixel_at_place(picture, 308, 216) & 0xFFFFFFu, 0xFFFFFFu);  // in the circle
    EXPECT_GT(red_pixels(picture), 80u);
    const std::uint32_t arrow = pixel_at_place(picture, 64, 131);
    EXPECT_GT(arrow & 0xFFu, 200u);
    EXPECT_LT(arrow >> 8 & 0xFFu, 160u);
    options.rows = PictureRows{200, 260};
    const Picture rows = draw(g, options);
    EXPECT_TRUE(std::equal(rows.pixels.begin(), rows.pixels.end(),
                           picture.pixels.begin() + 200 * picture.width));
  }
}

/// Samples make it neither larger nor smaller.
TEST(AnnotationFiles, SizeDoesNotDependOnSamples) {
  const GraphicsSystem g = replayed(kScene);
  const auto red = [&](int samples) { return red_pixels(draw(g, {.samples = samples})); };
  EXPECT_NEAR(static_cast<double>(red(4)), static_cast<double>(red(1)),
              0.2 * static_cast<double>(red(1)));
}

TEST(AnnotationFiles, OfAView) {
  GraphicsSystem g;
  g.retain();
  replay(kScene, "scene.draw", g);
  Renderer renderer;
  const InView view = in_view(g, look_at({2, 1, 4}, {0, 0, 0}));
  EXPECT_GT(red_pixels(renderer.draw(view, {.samples = 1})), 80u);
  EXPECT_GT(red_pixels(renderer.draw(view, {.samples = 4})), 80u);
}

TEST(AnnotationFiles, Osmesa) {
  if (!osmesa_available()) GTEST_SKIP();
  const Picture picture = draw(replayed(kScene), {.device = "osmesa"});
  EXPECT_EQ(pixel_at_place(picture, 308, 216) & 0xFFFFFFu, 0xFFFFFFu);
  EXPECT_GT(red_pixels(picture), 80u);
}

/// In millimetres on paper, by every vector device: a picture of 512 pixels is 190 mm wide on A4.
TEST(AnnotationFiles, MillimetresOnPaper) {
  const GraphicsSystem g = replayed(
      "open-segment 1\nset-annotation-size 3.5 mm\nleader-3 0 0 0 \"A\" 20 10\nclose-segment\n");
  DrawOptions options;
  options.vectors.paper = Paper{};
  const std::string svg = without_keys(draw_as(g, "svg", options));
  const double pixel = fit_on_paper(Paper{}, 512, 512).pixel;
  EXPECT_NE(svg.find(fmt::format("font-size:{:.3f}px", 3.5 / 0.72 / pixel)), svg.npos) << svg;
  EXPECT_NE(without_keys(draw_as(g, "svg")).find("font-size:18.373px"), svg.npos);
  EXPECT_GT(draw_as(g, "pdf", options).size(), 1000u);
  EXPECT_NE(draw_as(g, "pdf"), draw_as(g, "pdf", options));
  EXPECT_GT(draw_as(g, "eps").size(), 1000u);
  DrawOptions with_pens;
  with_pens.pens = Pens{};
  const std::string pens = draw_as(g, "svg", with_pens);
  EXPECT_NE(pens.find("stroke-width=\"0.25\""), pens.npos) << pens;
}

/// Numbers are strokes; nothing is left out.
TEST(AnnotationFiles, PensDrawLetters) {
  DrawOptions options;
  options.pens = Pens{};
  const auto size = [&](std::string_view text) {
    const GraphicsSystem g =
        replayed(fmt::format("open-segment 1\nleader-3 0 0 0 \"{}\" 10 10\nclose-segment\n", text));
    return draw_as(g, "svg", options).size();
  };
  EXPECT_GT(size("A"), size(""));
  EXPECT_GT(size("AB"), size("A"));
  EXPECT_EQ(size("I"), size("I"));
  EXPECT_NE(size("W"), size("I"));
}

/// Letters follow each other, within the width; a character without strokes is a box.
TEST(AnnotationFiles, StrokeLetters) {
  for (const std::string_view text : {"AB", "jy", "1.5", "\u00d830", "a b", "\u00e9\u4e00"}) {
    const StrokeLetters letters = stroke_letters(text);
    const StrokeLetters twice = stroke_letters(std::string(text) + std::string(text));
    ASSERT_EQ(twice.strokes.size(), 2 * letters.strokes.size()) << text;
    for (std::size_t k = 0; k < letters.strokes.size(); ++k) {
      const auto& [from, to] = letters.strokes[k];
      for (const Point2& p : {from, to}) {
        EXPECT_TRUE(p.x >= 0.0 && p.x <= letters.width && p.y >= -0.4 && p.y <= 1.0) << text;
      }
      EXPECT_GT(twice.strokes[letters.strokes.size() + k].first.x, letters.width) << text;
    }
  }
  EXPECT_EQ(stroke_letters("\u00e9").strokes.size(), 4u);
  EXPECT_EQ(stroke_letters("").width, 0.0);
}

/// Without annotation nothing changes, by a device that would draw it.
TEST(AnnotationFiles, SettingsAloneDrawNothing) {
  const std::string_view plain =
      "open-segment 1\npolygon-abs-3 0 0 0  1 0 0  1 1 0\nclose-segment\n";
  const std::string with =
      "set-annotation-size 9 mm\nset-annotation-placement auto\n" + std::string(plain);
  for (const char* format : {"svg", "pdf", "png"}) {
    EXPECT_EQ(draw_as(replayed(plain), format), draw_as(replayed(with), format));
  }
}

}  // namespace
}  // namespace displayfile
