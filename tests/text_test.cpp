// Texts, from the routine to every kind of picture. What letters look like is the fonts' business:
// tests look where there is ink, and of what colour.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "clip/error.h"
#include "displayfile/retained_views.h"
#include "displayfile/text/drawing_program.h"
#include "displayfile/text/dump.h"
#include "displayfile/text/dump_compare.h"
#include "displayfile/turntable.h"
#include "interp/draw.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/software.h"
#include "interp/text/seen_texts.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

using enum TextStyle::Alignment;

std::string error_of(std::string_view program) {
  GraphicsSystem system;
  try {
    replay(program, "a.draw", system);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

GraphicsSystem system_of(std::string_view program) {
  GraphicsSystem system;
  replay(program, "a.draw", system);
  return system;
}

std::string dump_of(std::string_view program) { return dump(system_of(program).display_file()); }

// ---- Drawing programs and dumps ---------------------------------------------------------------

TEST(Text, ErrorsSayWhere) {
  const auto line = [](std::string_view text) {
    return error_of(fmt::format("open-segment 1\n {}\nclose-segment\n", text));
  };
  EXPECT_EQ(line("text"), "a.draw:2:6: text: 0 arguments, expected 1: \"characters\"");
  EXPECT_EQ(line("text a"), "a.draw:2:7: expected a text in quotation marks, not 'a'");
  EXPECT_EQ(line("text two words"), "a.draw:2:11: text: 2 arguments, expected 1: \"characters\"");
  EXPECT_EQ(line("text \"\u00e9 b"),
            "a.draw:2:11: the text does not end: expected a quotation mark");
  EXPECT_EQ(line("text \"a\\\""), "a.draw:2:11: the text does not end: expected a quotation mark");
  EXPECT_EQ(line("text \"a\\"), "a.draw:2:10: the text does not end: expected a quotation mark");
  EXPECT_EQ(line("text \""), "a.draw:2:8: the text does not end: expected a quotation mark");
  EXPECT_EQ(line("text \"\u00e9\\n\""),
            "a.draw:2:9: expected \\\" or \\\\ after a backslash in a text");
  EXPECT_EQ(line("text \"a\"b"), "a.draw:2:10: expected a blank after the text's quotation mark");
  EXPECT_EQ(line("text \"a\tb\""),
            "a.draw:2:9: character U+0009 in a text: expected characters that can be drawn");
  EXPECT_EQ(line("text \"\u00e9\u0085\""),
            "a.draw:2:9: character U+0085 in a text: expected characters that can be drawn");
  EXPECT_EQ(line("text \"\uFFFE\""),
            "a.draw:2:8: character U+FFFE in a text: expected characters that can be drawn");
  EXPECT_EQ(line("text \"\xC3(\""),
            "a.draw:2:8: not a drawing program: byte 0xc3, expected UTF-8 text");
  EXPECT_EQ(error_of("text \"a\"\n"), "a.draw:1:1: no segment open");
  EXPECT_EQ(line("set-text-style"),
            "a.draw:2:16: set-text-style: 0 arguments, expected size [left|centre|right] [always]");
  EXPECT_EQ(line("set-text-style 0"),
            "a.draw:2:2: text size 0: expected more than 0 and at most 1, the picture's height");
  EXPECT_EQ(line("set-text-style 1.5"),
            "a.draw:2:2: text size 1.5: expected more than 0 and at most 1, the picture's height");
  EXPECT_EQ(line("set-text-style x"), "a.draw:2:17: expected a number, not 'x'");
  EXPECT_EQ(line("set-text-style 1 middle"),
            "a.draw:2:19: expected left, centre or right, not 'middle'");
  EXPECT_EQ(line("set-text-style 1 left never"),
            "a.draw:2:24: expected always, or nothing, not 'never'");
  EXPECT_EQ(line("set-text-style 1 always left"),
            "a.draw:2:19: expected left, centre or right, not 'always'");
}

TEST(Text, TheApiRefusesWhatCannotBeDrawn) {
  GraphicsSystem g;
  EXPECT_THROW(g.text("a"), Error);
  g.open_segment(1);
  for (const char* bad : {"\n", "a\tb", "\x7F", "\xC2\x80", "\xFF", "\xC3", "\xED\xA0\x80",
                          "\xEF\xBF\xBF", "\xF4\x90\x80\x80"}) {
    EXPECT_THROW(g.text(bad), Error) << bad;
  }
  EXPECT_THROW(g.text(std::string(GraphicsSystem::kLongestText + 1, 'a')), Error);
  EXPECT_THROW(g.set_text_style({std::numeric_limits<double>::quiet_NaN()}), Error);
  EXPECT_THROW(g.set_text_style({-0.1}), Error);
  EXPECT_FALSE(g.display_file().has_texts());
  g.text("\u00e9\u2212\U0001F4D0");
  g.text(std::string(GraphicsSystem::kLongestText, 'a'));
  EXPECT_TRUE(g.display_file().has_texts());
}

/// Styles where they change; texts stand among lines, whose pen they do not move.
TEST(Text, CanonicalDump) {
  EXPECT_EQ(dump_of("set-window 0 1 0 1\n"
                    "open-segment 1\n"
                    "move-abs-3 .25 .25 0\n"
                    "text \"a\"\n"
                    "line-abs-3 .5 .25 0\n"
                    "text \"\\\"q\\\" \\\\ # \u03c0\"\n"
                    "text \"\"\n"
                    "line-abs-3 .75 .25 1\n"
                    "set-line-style dashed 1 0 0\n"
                    "set-text-style .05 right\n"
                    "text \"b\"\n"
                    "set-text-style .05 right always\n"
                    "text \"c\"\n"
                    "move-abs-2 2 2\n"
                    "text \"outside\"\n"
                    "close-segment\n"),
            "displayfile-dump 1\n"
            "segment 1 visible\n"
            "line-style solid 0 0 0 1\n"
            "text-style 0.03 left\n"
            "text 0.25 0.25 0.75 \"a\"\n"
            "move 0.25 0.25 0.75\n"
            "line 0.5 0.25 0.75\n"
            "text 0.5 0.25 0.75 \"\\\"q\\\" \\\\ # \u03c0\"\n"
            "line 0.75 0.25 1\n"
            "line-style dashed 1 0 0 1 6 4\n"
            "text-style 0.05 right\n"
            "text 0.75 0.25 1 \"b\"\n"
            "text-style 0.05 right always\n"
            "text 0.75 0.25 1 \"c\"\n"
            "end\n");
}

TEST(Text, FirstDifferenceOfDumps) {
  const auto with = [](std::string_view text) {
    return fmt::format("displayfile-dump 1\nsegment 1 visible\n{}\nend\n", text);
  };
  EXPECT_EQ(first_difference(with("text 0 0 1 \"a b\""), with("text 0 0 1 \"a c d\"")),
            "segment 1, instruction 1 (text 0 0 1 \"a b\"): text is \"a b\", expected \"a c d\"");
  EXPECT_EQ(first_difference(with("text 0 .5 1 \"a b\""), with("text 0 0 1 \"a b\"")),
            "segment 1, instruction 1 (text 0 .5 1 \"a b\"): y is .5, expected 0");
  EXPECT_EQ(first_difference(with("text-style 0.5 left"), with("text-style 0.5 right")),
            "segment 1, instruction 1 (text-style 0.5 left): alignment is left, expected right");
}

/// Image transformations act on the anchor alone.
TEST(Text, ImageTransformationMovesTheAnchor) {
  const std::string moved = dump_of(
      "set-window 0 1 0 1\nopen-segment 1\nmove-abs-2 .25 .5\ntext \"a\"\nclose-segment\n"
      "set-image-scale 1 .5 .25\nset-image-translation 1 .5 0\n");
  EXPECT_NE(moved.find("text-style 0.03 left\ntext 0.625 0.125 0.75 \"a\"\n"), moved.npos) << moved;
}

/// Orders are of polygons and lines; texts follow, with their styles and segments.
TEST(Text, SortsKeepTexts) {
  for (const char* method : {"bsp", "depth-sort"}) {
    for (const char* scope : {"segment", "all"}) {
      SCOPED_TRACE(std::string(method) + " " + scope);
      GraphicsSystem g =
          system_of(fmt::format("set-window 0 1 0 1\nset-hidden-line-removal on\n"
                                "set-hidden-method {}\nset-hidden-scope {}\n"
                                "open-segment 1\ntext \"first\"\n"
                                "polygon-abs-2 0 0 1 0 1 1\nclose-segment\n"
                                "open-segment 2\nset-line-style none\n"
                                "move-abs-3 .5 .25 .5\ntext \"second\"\n"
                                "polygon-abs-2 0 0 1 0 1 1\nclose-segment\n",
                                method, scope));
      SortedDisplayFile sorted;
      const std::string text = dump(sorted.update(g, g.hidden_method(), {}));
      EXPECT_NE(text.find("text 0 0 0.75 \"first\"\n"), text.npos) << text;
      EXPECT_NE(text.find("text 0.5 0.25 0.875 \"second\"\n"), text.npos) << text;
      const std::string first_segment = text.substr(0, text.find("segment 2"));
      EXPECT_EQ(first_segment.find("second"), text.npos) << text;
    }
  }
}

// ---- Pixels -----------------------------------------------------------------------------------

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

constexpr std::string_view kScene =
    "set-window 0 1 0 1\n"
    "set-hidden-line-removal on\n"
    "open-segment 1\n"
    "set-line-style solid 0 .2 1\n"
    "set-fill-style solid .9 .9 .6\n"
    "polygon-abs-3 .125 .125 0  .875 .125 0  .875 .875 0  .125 .875 0\n";

std::string scene_with(std::string_view texts, std::string_view before = "") {
  return fmt::format("{}{}{}close-segment\n", before, kScene, texts);
}

Picture picture_of(std::string_view program, DrawOptions options = {}) {
  options.width = 320;
  options.height = 200;
  return draw(system_of(program), options);
}

/// The ink of texts in the scene.
std::optional<Box> ink(std::string_view texts, const DrawOptions& options = {},
                       std::string_view before = "") {
  return difference(picture_of(scene_with(texts, before), options),
                    picture_of(scene_with("", before), options));
}

/// Letters stand on their base line, at the side of the anchor that the style says, about as wide
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

/// Over no background the picture, laid on white, is what it is over white, but for rounding: once
/// in a component's steps, and a pixel of samples twice.
TEST(Text, IsSeenOnTransparentGround) {
  const std::string program =
      "set-background none\n" + scene_with(
                                    "set-text-style .25\nmove-abs-3 .02 .5 0\n"
                                    "text \"HHHH\"\nset-line-style solid 1 0 0\n"
                                    "move-abs-3 .04 .45 0\ntext \"OO\"\n");
  for (const int samples : {1, 4}) {
    DrawOptions options;
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
  // In perspective, what is behind the eye.
  EXPECT_FALSE(ink("move-abs-3 .5 .5 9\nset-text-style .2 centre always\ntext \"HH\"\n", {},
                   "set-perspective .5 .5 4\n"));
}

std::vector<HiddenMethod> methods_that_remove() {
  using enum HiddenMethod;
  return {automatic, z_buffer, scan_line,  scan_line_z,   ray_cast,
          warnock,   bsp,      depth_sort, plain_z_buffer};
}

/// By every method a text is seen where its anchor is: on the surface, its corner, its side, before
/// it; beside it; and always if its style says so.
TEST(Text, IsSeenWhereItsAnchorIs) {
  for (const HiddenMethod method : methods_that_remove()) {
    SCOPED_TRACE(name_of(method));
    DrawOptions options;
    options.hidden = method;
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
  DrawOptions not_removed;
  not_removed.hidden = HiddenMethod::none;
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
    DrawOptions options;
    options.hidden = method;
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
  draw_rows_with_software(file, request, [&](const Picture& rows) {
    all.height += rows.height;
    all.pixels.insert(all.pixels.end(), rows.pixels.begin(), rows.pixels.end());
  });
  return all;
}

/// The picture is the same row by row, and by any number of threads; identifiers and depths know
/// nothing of texts.
TEST(Text, SamePixelsHoweverTheyAreDrawn) {
  const std::string texts =
      "set-text-style .4 centre\nmove-abs-3 .5 .37 0\ntext \"H\u00e9g\"\n"
      "set-text-style .05 left\nmove-abs-3 .2 .7777 0\ntext \"small, on several strips\"\n";
  const GraphicsSystem g = system_of(scene_with(texts)), plain = system_of(scene_with(""));
  for (const HiddenMethod method :
       {HiddenMethod::none, HiddenMethod::z_buffer, HiddenMethod::scan_line_z}) {
    RasterRequest request;
    request.width = 1301;
    request.height = 2003;
    request.method = method;
    request.ids = request.depth = true;
    const Picture whole = draw_with_software(g.display_file(), request);
    EXPECT_TRUE(joined_rows(g.display_file(), request).pixels == whole.pixels);
    request.threads = 3;
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
  request.method = HiddenMethod::z_buffer;
  GraphicsSystem g = system_of(scene_with(""));
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
  DrawOptions options;
  options.device = "osmesa";
  for (const HiddenMethod method :
       {HiddenMethod::none, HiddenMethod::z_buffer, HiddenMethod::bsp}) {
    options.hidden = method;
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
        "open-segment 1\nset-text-style 1\ntext \"H\"\nclose-segment\nset-image-translation 1 {}\n",
        far);
    const Picture picture = picture_of(program);
    EXPECT_EQ(std::ranges::count(picture.pixels, 0xFFFFFFFFu), 320 * 200) << far;
  }
}

// ---- Vectors ------------------------------------------------------------------------------------

class TextFile : public test::TemporaryFolder {
 protected:
  std::string drawn(std::string_view program, const std::string& name,
                    const DrawOptions& options = {}) {
    draw(system_of(program), file(name), options);
    return test::content(file(name));
  }
};

TEST_F(TextFile, SvgHasTextElementsAfterAllElse) {
  const std::string svg = drawn(scene_with("move-abs-3 .5 .25 0\nset-text-style .05 centre\n"
                                           "text \"x < y & \\\"z\\\" > \u03c0\"\n"
                                           "move-abs-3 .5 .5 -1\ntext \"hidden\"\n"
                                           "set-text-style .05 centre always\ntext \" always\"\n"
                                           "set-line-style solid 1 0 0\n"
                                           "set-text-style .03 right\n"
                                           "move-abs-3 .875 .875 0\ntext \"corner\"\n"
                                           "polygon-abs-3 0 0 1  .1 0 1  .1 .1 1\n"),
                                "a.svg");
  EXPECT_NE(
      svg.find("</g>\n"
               "<g id=\"segment-1-2\" class=\"segment\">\n"
               "<text class=\"t1\" x=\"256\" y=\"384\">x &lt; y &amp; \"z\" &gt; "
               "\u03c0</text>\n"
               "<text class=\"t1\" xml:space=\"preserve\" x=\"256\" y=\"256\"> always</text>\n"
               "<text class=\"t2\" x=\"448\" y=\"64\">corner</text>\n"
               "</g>\n</svg>\n"),
      svg.npos)
      << svg;
  EXPECT_NE(svg.find("text{font-family:sans-serif}\n"
                     ".t1{fill:#0033ff;font-size:25.6px;text-anchor:middle}\n"
                     ".t2{fill:#ff0000;font-size:15.36px;text-anchor:end}\n"),
            svg.npos)
      << svg;
  EXPECT_EQ(svg.find("hidden"), svg.npos);
}

TEST_F(TextFile, SvgByEveryMethodHidesTheSame) {
  for (const HiddenMethod method : methods_that_remove()) {
    DrawOptions options;
    options.hidden = method;
    const std::string svg = drawn(scene_with("move-abs-3 .5 .25 -1\ntext \"behind\"\n"
                                             "move-abs-3 .125 .25 0\ntext \"side\"\n"),
                                  "a.svg", options);
    EXPECT_EQ(svg.find("behind"), svg.npos) << name_of(method);
    EXPECT_NE(svg.find("side"), svg.npos) << name_of(method);
  }
  // What auto takes must not depend on whether polygons hide each other.
  EXPECT_EQ(drawn("set-hidden-line-removal on\nset-line-style none\nopen-segment 1\n"
                  "polygon-abs-2 0 0 1 0 1 1\nmove-abs-3 .7 .3 -1\ntext \"behind\"\n"
                  "close-segment\n",
                  "a.svg")
                .find("behind"),
            std::string::npos);
  DrawOptions none;
  none.hidden = HiddenMethod::none;
  EXPECT_NE(
      drawn(scene_with("move-abs-3 .5 .25 -1\ntext \"behind\"\n"), "a.svg", none).find("behind"),
      std::string::npos);
}

/// Without a text nothing of a file speaks of texts.
TEST_F(TextFile, SvgWithoutTextIsAsItWas) {
  EXPECT_EQ(drawn(scene_with(""), "a.svg").find("text"), std::string::npos);
}

/// As somebody else reads the PDF.
TEST_F(TextFile, PdfHoldsTheCharacters) {
  if (std::system("command -v pdftotext > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "pdftotext is not installed";
  }
  drawn(scene_with("move-abs-3 .5 .25 0\nset-text-style .05 centre\ntext \"caf\u00e9 (1)\"\n"
                   "move-abs-3 .5 .5 -1\ntext \"hidden\"\n"),
        "a.pdf");
  const std::string out = file("a.txt").string();
  ASSERT_EQ(std::system(fmt::format("pdftotext '{}' '{}'", file("a.pdf").string(), out).c_str()),
            0);
  const std::string text = test::content(out);
  EXPECT_NE(text.find("caf\u00e9 (1)"), text.npos) << text;
  EXPECT_EQ(text.find("hidden"), text.npos) << text;
}

// ---- Retained scenes ----------------------------------------------------------------------------

constexpr std::string_view kRetained =
    "set-view-depth -2 2\n"
    "open-segment 1\n"
    "set-text-style .05 centre\n"
    "move-abs-3 0 0 .5\n"
    "text \"front\"\n"
    "set-line-style solid 1 0 0\n"
    "polygon-abs-3 -.5 -.5 0  .5 -.5 0  .5 .5 0  -.5 .5 0\n"
    "move-abs-3 0 0 -.5\n"
    "text \"back\"\n"
    "close-segment\n"
    "open-segment 2\n"
    "move-abs-3 .9 0 0\n"
    "text \"alone\"\n"
    "close-segment\n";

std::vector<std::string> characters(const std::vector<ViewedText>& texts) {
  std::vector<std::string> all;
  for (const ViewedText& text : texts) all.push_back(text.characters);
  return all;
}

/// In the application's own view the same display file; turned, what was behind is in front.
TEST(Text, IsRetained) {
  using Texts = std::vector<std::string>;
  GraphicsSystem g;
  RetainedScene scene;
  g.retain(&scene);
  replay(kRetained, "a.draw", g);
  const Turntable turntable(scene, g.display_file(), g.view());
  RetainedViews trees(scene, g.display_file(), {});
  const WorldViews rays(scene, g.display_file());
  const auto seen = [&](double degrees) {
    const auto [view, lights] = turntable.at(degrees);
    const auto by_tree = characters(seen_texts(trees.view(view, lights), false));
    const auto by_rays = characters(seen_texts(rays.view(view, lights).display_file, true));
    EXPECT_EQ(by_tree, by_rays);
    return by_tree;
  };
  EXPECT_EQ(seen(0), (Texts{"front", "alone"}));
  EXPECT_EQ(seen(180), (Texts{"back", "alone"}));
  DisplayFile drawn = rays.as_drawn().display_file;
  EXPECT_EQ(dump(drawn), dump(g.display_file()));
  // With segments renamed and deleted.
  g.rename_segment(1, 3);
  g.delete_segment(2);
  EXPECT_EQ(
      characters(seen_texts(WorldViews(scene, g.display_file()).as_drawn().display_file, true)),
      Texts{"front"});
  EXPECT_EQ(dump(WorldViews(scene, g.display_file()).as_drawn().display_file),
            dump(g.display_file()));
}

}  // namespace
}  // namespace displayfile
