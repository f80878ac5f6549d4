// Annotation in pictures of every format.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interp/draw/draw.h"
#include "interp/draw/renderer.h"
#include "interp/draw/turntable_renderer.h"
#include "interp/opengl/osmesa.h"
#include "interp/vector/pens/pen_drawing.h"
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
  const DrawOptions with_pens{.pens = Pens{}};
  const std::string pens = draw_as(g, "svg", with_pens);
  EXPECT_NE(pens.find("stroke-width=\"0.25\""), pens.npos) << pens;
}

/// Numbers are strokes; nothing is left out.
TEST(AnnotationFiles, PensDrawLetters) {
  const DrawOptions options{.pens = Pens{}};
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

/// A pen's paths for a program's red lines, in millimetres from the sheet's corner, joined.
std::vector<PenPath> paths_of_red(std::string_view program, const Pens& pens,
                                  const Background& background = {}) {
  const PenDrawing drawing =
      pen_drawing(replayed(program).display_file(), 512, 512, Paper{}, pens, background);
  for (const PenLayer& layer : drawing.layers) {
    if (layer.pen.colour == pixel_of(Colour(1, 0, 0))) return layer.paths;
  }
  return {};
}

/// A red line through a balloon whose centre is the picture's: as in SVG, where the circle is
/// filled with the background's colour. The balloon's radius is 1.15 times 3.5 mm.
constexpr std::string_view kLineBehindBalloon =
    "set-line-style solid 1 0 0\nopen-segment 1\nmove-abs-2 -0.5 0\nline-abs-2 0.5 0\n"
    "set-line-style solid 0 0 0\nballoon-3 0 0 0 7 \"\" 0 0\nclose-segment\n";

TEST(AnnotationFiles, PensDrawNothingBehindBalloons) {
  const std::vector<PenPath> paths = paths_of_red(kLineBehindBalloon, {});
  ASSERT_EQ(paths.size(), 2u);
  const double middle = 105'000.0, radius = 4'025.0;
  for (const PenPath& path : paths) {
    ASSERT_EQ(path.points.size(), 2u);
    const auto [low, high] = std::minmax(path.points[0].x, path.points[1].x);
    const bool is_left = low < middle;
    EXPECT_NEAR(is_left ? high : low, is_left ? middle - radius : middle + radius, 1.0);
    EXPECT_NEAR(is_left ? low : high, is_left ? 57'500.0 : 152'500.0, 1.0);
  }
  // Without a background nothing is covered, as in SVG.
  Background none;
  none.kind = Background::Kind::none;
  EXPECT_EQ(paths_of_red(kLineBehindBalloon, {}, none).size(), 1u);
}

/// Hatching and the dashes of dashed lines are covered too; lines drawn after a balloon are not.
TEST(AnnotationFiles, PensCoverHatchingAndDashesBeforeABalloon) {
  Pens hatched;
  hatched.hatching = Hatching{.angle = 0.0, .colour = Colour(1, 0, 0)};
  const std::string square =
      "set-line-style none\nset-fill-style solid 0 0 0\nopen-segment 1\n"
      "polygon-abs-3 -.5 -.5 0  .5 -.5 0  .5 .5 0  -.5 .5 0\n";
  const std::string balloon =
      "set-line-style solid 0 0 0\nballoon-3 0 0 0 7 \"\" 0 0\nclose-segment\n";
  const auto reaches_middle = [](const std::vector<PenPath>& paths) {
    return std::ranges::any_of(paths, [](const PenPath& path) {
      for (std::size_t i = 1; i < path.points.size(); ++i) {
        const auto [low, high] = std::minmax(path.points[i - 1].x, path.points[i].x);
        const bool is_level = std::abs(path.points[i].y - 148'500) < 3'000 &&
                              path.points[i].y == path.points[i - 1].y;
        if (is_level && low < 104'500 && high > 105'500) return true;
      }
      return false;
    });
  };
  EXPECT_TRUE(reaches_middle(paths_of_red(square + "close-segment\n", hatched)));
  EXPECT_FALSE(reaches_middle(paths_of_red(square + balloon, hatched)));
  const std::string dashed =
      "set-line-style dashed 1 0 0 1 60 4\nopen-segment 1\nmove-abs-2 -0.5 0\n"
      "line-abs-2 0.5 0\n";
  EXPECT_FALSE(reaches_middle(paths_of_red(dashed + balloon, {})));
  const std::string leader_after =
      "open-segment 1\nset-line-style solid 0 0 0\nballoon-3 0 0 0 7 \"\" 0 0\n"
      "set-line-style solid 1 0 0\nleader-3 -0.5 0 0 \"\" 100 0\nclose-segment\n";
  EXPECT_TRUE(reaches_middle(paths_of_red(leader_after, {})));
}

/// Letters are in a Hershey font, as wide as the annotation's lines, with one pen.
TEST(AnnotationFiles, PensWriteWithThePenOfTheLines) {
  const GraphicsSystem g =
      replayed("open-segment 1\nleader-3 0 0 0 \"AWX\" 10 10\nclose-segment\n");
  Pens hershey;
  hershey.lettering.font = "hershey";
  const PenDrawing usual = pen_drawing(g.display_file(), 512, 512, Paper{}, {});
  const PenDrawing set = pen_drawing(g.display_file(), 512, 512, Paper{}, hershey);
  ASSERT_EQ(usual.layers.size(), 1u);
  ASSERT_EQ(set.layers.size(), 1u);
  EXPECT_EQ(usual.layers[0].pen.width, 250);
  EXPECT_EQ(usual.layers[0].paths.size(), set.layers[0].paths.size());
}

/// An arrowhead ends where it points to, with the round end of the pen.
TEST(AnnotationFiles, ArrowheadsOfPensEndAtTheirTips) {
  const std::vector<PenPath> paths = paths_of_red(
      "set-line-style solid 1 0 0\nopen-segment 1\nleader-3 0 0 0 \"\" -30 0\nclose-segment\n", {});
  std::int32_t last = 0, high = 0;
  for (const PenPath& path : paths) {
    for (const SheetPoint& p : path.points) {
      last = std::max(last, p.x);
      high = std::max(high, std::abs(p.y - 148'500));
    }
  }
  EXPECT_NEAR(last, 105'000 - 125, 2);
  EXPECT_LT(high, 555);
  EXPECT_GT(high, 430);
}

/// The height of a picture's letters is that of the paper: 600 dots per inch have more pixels.
TEST(AnnotationFiles, MillimetresAreThoseOfTheDensity) {
  const GraphicsSystem g = replayed(
      "open-segment 1\nset-line-style solid 1 0 0\nballoon-3 0 0 0 7 \"\" 0 0\nclose-segment\n");
  DrawOptions options;
  options.samples = 1;
  const auto extent = [&](std::optional<double> dpi) {
    options.dpi = dpi;
    const Picture picture = draw(g, options);
    std::size_t first = picture.pixels.size(), last = 0;
    for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
      if ((picture.pixels[k] >> 8 & 0xFFu) > 200u) continue;
      first = std::min(first, k / 512);
      last = std::max(last, k / 512);
    }
    return static_cast<double>(last - first);
  };
  const double usual = extent(std::nullopt);
  EXPECT_NEAR(usual, 2 * 4.025 * 96 / 25.4, 2.0);
  EXPECT_NEAR(extent(300.0), 2 * 4.025 * 300 / 25.4, 2.0);
}

/// Annotation that does not fit on that paper is warned of by name.
TEST(AnnotationFiles, WhatHasNoRoomIsWarnedOf) {
  GraphicsSystem g = replayed(
      "set-annotation-placement auto\nopen-segment 1\n"
      "polygon-abs-3 -.7 -.7 0  .7 -.7 0  .7 .7 0  -.7 .7 0\n"
      "balloon-3 0 0 0 1 \"A name of a part\"\nparts-list\nclose-segment\n");
  const auto warnings_on = [&](double side) {
    std::string all;
    DrawOptions options;
    options.vectors.paper = Paper{side, side};
    options.warn = [&](const DrawWarning& warning) { all += warning.text; };
    draw_as(g, "svg", options);
    return all;
  };
  EXPECT_NE(warnings_on(120.0).find("no room for the parts list, "), std::string::npos)
      << warnings_on(120.0);
  EXPECT_NE(warnings_on(100.0).find("is cut off: the parts list: "), std::string::npos)
      << warnings_on(100.0);
  EXPECT_EQ(warnings_on(1000.0), "");
}

/// A leader to the right of a square, whose text leaves the picture, and a dimension below it.
constexpr std::string_view kBeyond =
    "set-line-style solid black\nset-annotation-size 3.5 mm\nopen-segment 1\n"
    "polygon-abs-3 -.5 -.5 0  .5 -.5 0  .5 .5 0  -.5 .5 0\n"
    "leader-3 .4 0 0 \"Hardened and ground\" 20 5\n"
    "linear-dimension-3 x -.5 -.5 0  .5 -.5 0  0 -.7 0\n"
    "linear-dimension-3 y -.5 -.5 0  -.5 .5 0  -.2 0 0\nclose-segment\n";
constexpr std::string_view kCutOff =
    "annotation reaches beyond the picture and is cut off: leader \"Hardened and ground\", "
    "dimension 1: expected larger paper, a larger window or a smaller scale, or "
    "set-annotation-placement auto";

std::vector<std::string> annotation_warnings(const std::function<void(DrawOptions&)>& drawing) {
  std::vector<std::string> all;
  DrawOptions options{.width = 256, .height = 256, .samples = 1};
  options.warn = [&](const DrawWarning& warning) {
    if (warning.kind == DrawWarning::Kind::annotation) all.push_back(warning.text);
  };
  drawing(options);
  return all;
}

TEST(AnnotationFiles, WhatIsCutOffIsNamedInEveryFormat) {
  const GraphicsSystem g = replayed(kBeyond);
  const std::vector<std::string> expected{std::string(kCutOff)};
  for (const char* format : {"svg", "pdf", "eps", "png", "ppm"}) {
    EXPECT_EQ(annotation_warnings([&](DrawOptions& o) { draw_as(g, format, o); }), expected)
        << format;
  }
  EXPECT_EQ(annotation_warnings([&](DrawOptions& o) { draw(g, o); }), expected);
  EXPECT_EQ(annotation_warnings([&](DrawOptions& o) {
              o.pens.emplace();
              o.vectors.paper = Paper{80.0, 80.0};
              draw_as(g, "svg", o);
            }),
            expected);
}

/// A scene in another view has the warning too; a turntable has it once.
TEST(AnnotationFiles, WhatIsCutOffInAViewIsNamed) {
  GraphicsSystem g;
  g.retain();
  replay(kBeyond, "scene.draw", g);
  const std::vector<std::string> expected{std::string(kCutOff)};
  for (const HiddenMethod method : {HiddenMethod::z_buffer, HiddenMethod::franklin}) {
    EXPECT_EQ(annotation_warnings([&](DrawOptions& o) {
                o.surfaces.method = method;
                Renderer renderer;
                renderer.draw(in_view(g, g.view()), o);
              }),
              expected);
  }
  EXPECT_EQ(annotation_warnings([&](DrawOptions& o) {
              TurntableRenderer turntable(g, *g.retained(), g.display_file(), {6}, o);
              for (int k = 0; k < 6; ++k) turntable.give_back(turntable.draw(k));
            }).size(),
            1u);
}

/// A leader and a balloon at the back of a box, a leader at its front, one inside of it by less
/// than its facets might be, and a dimension, which measures hidden edges too.
constexpr std::string_view kHiddenPoints =
    "set-annotation-size 1 mm\nopen-segment 1\nbox-3 -.5 .5  -.5 .5  -.5 .5\n"
    "leader-3 .1 0 -.5 \"behind\" 5 5\nballoon-3 0 .1 -.3 7 \"\" 5 5\n"
    "leader-3 .1 0 .5 \"before\" 5 5\nleader-3 .1 .2 .495 \"near\" 5 5\n"
    "linear-dimension-3 x -.5 -.5 -.5  .5 -.5 -.5  0 -.2 0\nclose-segment\n";
constexpr std::string_view kPointsAtHidden =
    "annotation points at what is hidden, as if it were seen: leader \"behind\", balloon 7: "
    "expected "
    "points that are seen, or another view";

TEST(AnnotationFiles, WhatPointsAtHiddenPointsIsNamed) {
  const GraphicsSystem g = replayed(kHiddenPoints);
  const std::vector<std::string> expected{std::string(kPointsAtHidden)};
  for (const HiddenMethod method :
       {HiddenMethod::z_buffer, HiddenMethod::bsp, HiddenMethod::franklin, HiddenMethod::map}) {
    for (const char* format : {"svg", "png"}) {
      if (method == HiddenMethod::map && format == std::string_view("png")) continue;
      EXPECT_EQ(annotation_warnings([&](DrawOptions& o) {
                  o.surfaces.method = method;
                  draw_as(g, format, o);
                }),
                expected)
          << name_of(method) << " " << format;
    }
  }
  EXPECT_EQ(annotation_warnings([&](DrawOptions& o) {
              o.surfaces.method = HiddenMethod::none;
              draw_as(g, "png", o);
            }),
            std::vector<std::string>());
  GraphicsSystem retained;
  retained.retain();
  replay(kHiddenPoints, "scene.draw", retained);
  EXPECT_EQ(annotation_warnings([&](DrawOptions& o) {
              o.surfaces.method = HiddenMethod::z_buffer;
              Renderer renderer;
              renderer.draw(in_view(retained, retained.view()), o);
            }),
            expected);
}

/// A point at the picture's edge is not beyond it; what is beyond with its figure is cut off like
/// the figure.
TEST(AnnotationFiles, WhatEndsAtTheEdgeIsNotCutOff) {
  const auto warned = [](std::string_view routines) {
    const GraphicsSystem g = replayed(fmt::format("open-segment 1\n{}close-segment\n", routines));
    return annotation_warnings([&](DrawOptions& o) { draw_as(g, "svg", o); }).size();
  };
  EXPECT_EQ(warned("leader-3 1 0 0 \"a\" -10 5\n"), 0u);
  EXPECT_EQ(warned("leader-3 .9 0 0 \"a\" -10 5\n"), 0u);
  EXPECT_EQ(warned("leader-3 .9 0 0 \"a\" 10 5\n"), 1u);
  EXPECT_EQ(warned("leader-3 2 0 0 \"a\" 10 5\n"), 0u);
  EXPECT_EQ(warned("leader-3 0 0 0 \"a\" 90000 5\n"), 1u);  // omitted
  EXPECT_EQ(warned("leader-3 .9 0 0 \"a\" -10 5\nclose-segment\nset-image-translation 1 3 0\n"
                   "open-segment 2\n"),
            0u);
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
