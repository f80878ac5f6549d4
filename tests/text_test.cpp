// Texts, from the routine to the display file, and in retained scenes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/text/dump_compare.h"
#include "displayfile/views/retained_views.h"
#include "displayfile/views/turntable.h"
#include "interp/draw/world_views.h"
#include "interp/text/seen_texts.h"
#include "tests/replayed.h"

namespace displayfile {
namespace {

using namespace test;

// ---- Drawing programs and dumps ---------------------------------------------------------------

TEST(Text, ErrorsSayWhere) {
  const auto line = [](std::string_view text) {
    return error_of_program(fmt::format("open-segment 1\n {}\nclose-segment\n", text));
  };
  EXPECT_EQ(line("text"), "scene.draw:2:6: text: 0 arguments, expected 1: \"characters\"");
  EXPECT_EQ(line("text a"), "scene.draw:2:7: expected a text in quotation marks, not 'a'");
  EXPECT_EQ(line("text two words"),
            "scene.draw:2:11: text: 2 arguments, expected 1: \"characters\"");
  EXPECT_EQ(line("text \"\u00e9 b"),
            "scene.draw:2:11: the text does not end: expected a quotation mark");
  EXPECT_EQ(line("text \"a\\\""),
            "scene.draw:2:11: the text does not end: expected a quotation mark");
  EXPECT_EQ(line("text \"a\\"),
            "scene.draw:2:10: the text does not end: expected a quotation mark");
  EXPECT_EQ(line("text \""), "scene.draw:2:8: the text does not end: expected a quotation mark");
  EXPECT_EQ(line("text \"\u00e9\\n\""),
            "scene.draw:2:9: expected \\\" or \\\\ after a backslash in a text");
  EXPECT_EQ(line("text \"a\"b"),
            "scene.draw:2:10: expected a blank after the text's quotation mark");
  EXPECT_EQ(line("text \"a\tb\""),
            "scene.draw:2:9: character U+0009 in a text: expected characters that can be drawn");
  EXPECT_EQ(line("text \"\u00e9\u0085\""),
            "scene.draw:2:9: character U+0085 in a text: expected characters that can be drawn");
  EXPECT_EQ(line("text \"\uFFFE\""),
            "scene.draw:2:8: character U+FFFE in a text: expected characters that can be drawn");
  EXPECT_EQ(line("text \"a\U0010FFFF\""),
            "scene.draw:2:9: character U+10FFFF in a text: expected characters that can be drawn");
  EXPECT_EQ(line("text \"\xC3(\""),
            "scene.draw:2:8: not a drawing program: byte 0xc3, expected UTF-8 text");
  EXPECT_EQ(error_of_program("text \"a\"\n"), "scene.draw:1:1: no segment open: open one first");
  EXPECT_EQ(
      line("set-text-style"),
      "scene.draw:2:16: set-text-style: 0 arguments, expected size [left|centre|right] [always]");
  EXPECT_EQ(
      line("set-text-style 0"),
      "scene.draw:2:2: text size 0: expected more than 0 and at most 1, the picture's height");
  EXPECT_EQ(
      line("set-text-style 1.5"),
      "scene.draw:2:2: text size 1.5: expected more than 0 and at most 1, the picture's height");
  EXPECT_EQ(line("set-text-style x"), "scene.draw:2:17: expected a number, not 'x'");
  EXPECT_EQ(line("set-text-style 1 middle"),
            "scene.draw:2:19: expected left, centre or right, not 'middle'");
  EXPECT_EQ(line("set-text-style 1 left never"),
            "scene.draw:2:24: expected always, or nothing, not 'never'");
  EXPECT_EQ(line("set-text-style 1 always left"),
            "scene.draw:2:19: expected left, centre or right, not 'always'");
}

TEST(Text, TheApiRefusesWhatCannotBeDrawn) {
  GraphicsSystem g;
  EXPECT_THROW(g.text("a"), Error);
  g.open_segment(1);
  for (const char* bad :
       {"\n", "a\tb", "\x7F", "\xC2\x80", "\xFF", "\xC3", "\xED\xA0\x80", "\xEF\xBF\xBF",
        "\xF4\x90\x80\x80", "\uFDD0", "\uFDEF", "\U0001FFFE", "\U0010FFFF"}) {
    EXPECT_THROW(g.text(bad), Error) << bad;
  }
  EXPECT_THROW(g.text(std::string(GraphicsSystem::kLongestText + 1, 'a')), Error);
  EXPECT_THROW(g.set_text_style({std::numeric_limits<double>::quiet_NaN()}), Error);
  EXPECT_THROW(g.set_text_style({-0.1}), Error);
  EXPECT_FALSE(g.display_file().has_texts());
  g.text("\u00e9\u2212\U0001F4D0\uFDCF\uFDF0\uFFFD\U0001FFFD\U00020000");
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
          replayed(fmt::format("set-window 0 1 0 1\nset-hidden-line-removal on\n"
                               "set-hidden-method {}\nset-hidden-scope {}\n"
                               "open-segment 1\ntext \"first\"\n"
                               "polygon-abs-2 0 0 1 0 1 1\nclose-segment\n"
                               "open-segment 2\nset-line-style none\n"
                               "move-abs-3 .5 .25 .5\ntext \"second\"\n"
                               "polygon-abs-2 0 0 1 0 1 1\nclose-segment\n",
                               method, scope));
      SortedDisplayFile sorted;
      const std::string text = dump(sorted.update(g, g.hidden_surfaces().method, {}));
      EXPECT_NE(text.find("text 0 0 0.75 \"first\"\n"), text.npos) << text;
      EXPECT_NE(text.find("text 0.5 0.25 0.875 \"second\"\n"), text.npos) << text;
      const std::string first_segment = text.substr(0, text.find("segment 2"));
      EXPECT_EQ(first_segment.find("second"), text.npos) << text;
    }
  }
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

std::vector<std::string> characters(const std::vector<DeviceText>& texts) {
  std::vector<std::string> all;
  for (const DeviceText& text : texts) all.push_back(text.characters);
  return all;
}

/// In the application's own view the same display file; from behind, hidden texts are in front.
TEST(Text, IsRetained) {
  using Texts = std::vector<std::string>;
  GraphicsSystem g;
  RetainedScene scene;
  g.retain(&scene);
  replay(kRetained, "scene.draw", g);
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
