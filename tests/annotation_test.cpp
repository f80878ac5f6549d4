// Annotation, from the routines to the display file.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/text/dump_compare.h"
#include "displayfile/views/scene_viewer.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/draw/world_views.h"
#include "tests/replayed.h"

namespace displayfile {
namespace {

using namespace test;

// ---- Drawing programs, dumps and records ------------------------------------------------------

TEST(Annotation, ErrorsSayWhere) {
  const auto line = [](std::string_view text) {
    return error_of_program(fmt::format("open-segment 1\n{}\nclose-segment\n", text));
  };
  EXPECT_EQ(
      line("leader-3 0 0 0"),
      "scene.draw:2:15: leader-3: 3 arguments, expected 4 or 6: x y z \"characters\" [right up]");
  EXPECT_EQ(line("leader-3 0 0 0 a"),
            "scene.draw:2:16: expected a text in quotation marks, not 'a'");
  EXPECT_EQ(line("leader-3 0 0 0 \"a\" 1 x"), "scene.draw:2:22: expected a number, not 'x'");
  EXPECT_EQ(
      line("leader-3 0 0 0 \"a\" 1 2e6"),
      "scene.draw:2:1: offset of annotation is 2000000: expected a finite number of magnitude "
      "at most 1e6");
  EXPECT_EQ(line("leader-3 0 0 2e100 \"a\""),
            "scene.draw:2:1: coordinates 0 0 2e+100: expected finite numbers of magnitude at most "
            "1e100");
  EXPECT_EQ(line("balloon-3 0 0 0 0"), "scene.draw:2:1: balloon number 0: expected 1 or more");
  EXPECT_EQ(line("balloon-3 0 0 0 1.5"), "scene.draw:2:17: expected a whole number, not '1.5'");
  EXPECT_EQ(line("balloon-3 0 0 0 1 \"a\" 2"),
            "scene.draw:2:24: balloon-3: 6 arguments, expected 4, 5 or 7: x y z number [\"name\" "
            "[right up]]");
  EXPECT_EQ(line("linear-dimension-3 w 0 0 0 1 1 1 0 1 0"),
            "scene.draw:2:20: expected x, y or z, not 'w'");
  EXPECT_EQ(line("linear-dimension-3 x 0 0 0 0 1 1 0 1 0"),
            "scene.draw:2:1: linear dimension: expected points that differ along the axis");
  EXPECT_EQ(line("scale-3 0 1 1\nlinear-dimension-3 x 0 0 0 1 1 1 0 1 0"),
            "scene.draw:3:1: linear dimension, of an axis that is scaled by 0: expected two "
            "different points");
  EXPECT_EQ(line("linear-dimension-3 x 0 0 0 1 1 1 0 nan 0"),
            "scene.draw:2:36: expected a finite number, not 'nan'");
  EXPECT_EQ(
      line("linear-dimension-3 x 0 0 0 1 1 1 0"),
      "scene.draw:2:35: linear-dimension-3: 8 arguments, expected 10: x|y|z x1 y1 z1 x2 y2 z2 "
      "dx dy dz");
  EXPECT_EQ(line("aligned-dimension-3 1 1 1 1 1 1 0 1 0"),
            "scene.draw:2:1: aligned dimension: expected two different points");
  EXPECT_EQ(line("diameter-dimension-3 1 1 1 1 1 1"),
            "scene.draw:2:1: diameter dimension: expected two different points");
  EXPECT_EQ(line("radius-dimension-3 1 1 1 1 1 1"),
            "scene.draw:2:1: radius dimension: expected two different points");
  EXPECT_EQ(line("angle-dimension-3 0 0 0 1 0 0 0 0 0 1"),
            "scene.draw:2:1: angle dimension: expected two different points");
  EXPECT_EQ(
      line("angle-dimension-3 0 0 0 1 0 0 2 0 0 1"),
      "scene.draw:2:1: angle dimension: expected points in different directions, not opposite");
  EXPECT_EQ(
      line("angle-dimension-3 0 0 0 1 0 0 -2 0 0 1"),
      "scene.draw:2:1: angle dimension: expected points in different directions, not opposite");
  EXPECT_EQ(line("angle-dimension-3 0 0 0 1 0 0 0 1 0 0"),
            "scene.draw:2:1: radius of an angle dimension 0: expected more than 0");
  EXPECT_EQ(line("title"), "scene.draw:2:6: title: 0 arguments, expected 1: \"characters\"");
  EXPECT_EQ(line("parts-list middle"),
            "scene.draw:2:12: expected top-left, top-right, bottom-left or bottom-right, not "
            "'middle'");
  EXPECT_EQ(line("set-annotation-size 0 mm"),
            "scene.draw:2:1: annotation size 0: expected more than 0 and at most 1000");
  EXPECT_EQ(line("set-annotation-size 1001 px"),
            "scene.draw:2:1: annotation size 1001: expected more than 0 and at most 1000");
  EXPECT_EQ(line("set-annotation-size 3 cm"),
            "scene.draw:2:23: expected mm or px, not 'cm': did you mean 'mm'?");
  EXPECT_EQ(line("set-annotation-ends ring"), "scene.draw:2:21: expected arrow or dot, not 'ring'");
  EXPECT_EQ(line("set-annotation-decimals 10"),
            "scene.draw:2:1: annotation decimals 10: expected 0 to 9");
  EXPECT_EQ(line("set-annotation-placement by-hand"),
            "scene.draw:2:26: expected entered or auto, not 'by-hand'");
  EXPECT_EQ(error_of_program("title \"a\"\n"), "scene.draw:1:1: no segment open: open one first");
}

TEST(Annotation, TheApiRefusesWhatCannotBeDrawn) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  GraphicsSystem g;
  g.open_segment(1);
  const std::string before = dump(g.display_file());
  const std::string too_long(GraphicsSystem::kLongestText + 1, 'a');
  for (const Annotation& bad : std::initializer_list<Annotation>{
           Leader{{0, 0, 0}, "a\tb"}, Leader{{0, 0, 0}, too_long}, Leader{{0, 0, kNan}, "a"},
           Leader{{0, 0, 0}, "a", Point2(kNan, 0)}, Balloon{{0, 0, 0}, -1},
           Balloon{{0, 0, 0}, 1, "\xFF"}, Title{"\n"},
           AlignedDimension{{0, 0, 0}, {1, 0, 0}, {kNan, 0, 0}},
           AlignedDimension{{0, 0, 0}, {1, 0, 0}, {0, 2e100, 0}},
           AngleDimension{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, kNan}}) {
    EXPECT_THROW(g.annotate(bad), Error) << bad.index();
  }
  g.begin_solid();
  EXPECT_THROW(g.annotate(Title{"a"}), Error);
  g.discard_solid();
  EXPECT_THROW(g.set_annotation_style({.size = kNan}), Error);
  EXPECT_THROW(g.set_annotation_style({.size = 7, .decimals = -1}), Error);
  EXPECT_EQ(dump(g.display_file()), before);
  EXPECT_FALSE(g.display_file().has_annotations());
  EXPECT_EQ(g.looks().annotation, AnnotationStyle());
}

/// The style that was set before recording began is recorded when it is set again.
TEST(Annotation, TheStyleIsRecordedWhereverRecordingBegins) {
  GraphicsSystem g;
  g.set_annotation_style({.size = 7, .ends = AnnotationStyle::Ends::dot, .decimals = 3});
  std::ostringstream recording;
  Recorder recorder(recording);
  g.set_recorder(&recorder);
  AnnotationStyle style = g.looks().annotation;
  style.decimals = 2;
  g.set_annotation_style(style);
  g.set_recorder(nullptr);
  GraphicsSystem again;
  replay(recording.str(), "recording", again);
  EXPECT_EQ(again.looks().annotation, style);
  // Recorded further, back to the defaults.
  g.set_annotation_style({});
  g.set_recorder(&recorder);
  g.set_annotation_style({});
  replay(recording.str(), "recording", again);
  EXPECT_EQ(again.looks().annotation, AnnotationStyle());
}

/// After all else of the segment, in the colour of the line style, with the style in force.
TEST(Annotation, CanonicalDump) {
  EXPECT_EQ(dump_of("set-window 0 1 0 1\n"
                    "open-segment 1\n"
                    "leader-3 .25 .5 0 \"a \\\"q\\\"\"\n"
                    "move-abs-3 .25 .25 0\n"
                    "set-annotation-size 7 px\n"
                    "set-annotation-ends dot\n"
                    "set-annotation-placement auto\n"
                    "set-line-style solid 1 0 0\n"
                    "balloon-3 .5 .5 0 12 \"Shaft\" -4 5\n"
                    "set-line-style none\n"
                    "line-abs-3 .75 .25 0\n"
                    "linear-dimension-3 x .25 .25 0  .75 .5 0  9 .25 0\n"
                    "title \"\"\n"
                    "parts-list top-left\n"
                    "leader-3 2 0 0 \"outside\"\n"
                    "close-segment\n"),
            "displayfile-dump 1\n"
            "segment 1 visible\n"
            "annotation leader 3.5 mm arrow entered 0 0 0 10.5 10.5 0.25 0.5 0.75 \"a \\\"q\\\"\"\n"
            "annotation balloon 7 px dot auto 1 0 0 -4 5 0.5 0.5 0.75 \"12\" \"Shaft\"\n"
            "annotation linear 7 px dot auto 0 0 0 0 0 0.25 0.25 0.75 0.75 0.5 0.75 0.25 0.5 0.75 "
            "0.75 0.5 0.75 \"0.5\"\n"
            "annotation title 7 px dot auto 0 0 0 0 0 \"\"\n"
            "annotation list 7 px dot auto 0 0 0 -1 1 \"\"\n"
            "end\n");
}

TEST(Annotation, FirstDifferenceOfDumps) {
  const auto with = [](std::string_view line) {
    return dump_of(fmt::format("open-segment 1\n{}\nclose-segment\n", line));
  };
  EXPECT_EQ(first_difference(with("set-annotation-size 3 mm\nleader-3 0 0 0 \"a\" 1 2"),
                             with("leader-3 0 0 0 \"a\" 1 2")),
            "segment 1, instruction 1 (annotation leader 3 mm arrow entered 0 0 0 1 2 0.5 0.5 0.75 "
            "\"a\"): size is 3, expected 3.5");
}

/// The texts of a segment's annotation.
std::vector<std::string> texts_of(std::string_view program) {
  const GraphicsSystem g =
      replayed(fmt::format("set-window -50 50 -50 50\nset-view-depth -100 100\nopen-segment 1\n{}"
                           "close-segment\n",
                           program));
  std::vector<std::string> texts;
  for (const KeptAnnotation& kept : g.display_file().segment(1).entered()->annotations()) {
    texts.push_back(kept.characters);
  }
  return texts;
}

/// The number is the model's measure: after the modelling transformation, whatever the view.
TEST(Annotation, MeasuresAreThoseOfTheModel) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(texts_of("linear-dimension-3 x 1 2 3  4 6 15  0 9 0\n"
                     "linear-dimension-3 y 1 2 3  4 6 15  9 0 0\n"
                     "linear-dimension-3 z 4 6 15  1 2 3  9 0 0\n"
                     "aligned-dimension-3 1 2 3  4 6 15  0 9 0\n"
                     "diameter-dimension-3 0 0 0  3 4 0\n"
                     "radius-dimension-3 0 0 0  3 4 0\n"
                     "angle-dimension-3 1 1 1  2 1 1  1 5 1  3\n"
                     "angle-dimension-3 0 0 0  1 0 0  -1 1 0  3\n"),
            (Texts{"3", "4", "12", "13",
                   "\u00d8"
                   "5",
                   "R5", "90\u00b0", "135\u00b0"}));
  EXPECT_EQ(texts_of("aligned-dimension-3 0 0 0  1 0.33333 0  0 9 0\n"
                     "set-annotation-decimals 0\n"
                     "aligned-dimension-3 0 0 0  10.5001 0 0  0 9 0\n"
                     "aligned-dimension-3 0 0 0  20 0 0  0 9 0\n"
                     "set-annotation-decimals 4\n"
                     "aligned-dimension-3 0 0 0  1 0.5 0  0 9 0\n"
                     "aligned-dimension-3 0 0 0  1.5 0 0  0 9 0\n"),
            (Texts{"1.05", "11", "20", "1.118", "1.5"}));
  // Along the axis of the turned and scaled part.
  EXPECT_EQ(texts_of("scale-3 2 3 1\nrotate-z-3 30\n"
                     "linear-dimension-3 x 0 0 0  4 7 0  0 -1 0\n"
                     "linear-dimension-3 y 0 0 0  4 7 0  -1 0 0\n"
                     "radius-dimension-3 0 0 0  0 0 4\n"),
            (Texts{"8", "21", "R4"}));
}

/// The number stands for <>; what is around it replaces the signs.
TEST(Annotation, DimensionsHaveTextsOfTheirOwn) {
  EXPECT_EQ(
      texts_of("set-dimension-text \"\u00d8<> H7\"\n"
               "diameter-dimension-3 0 0 0  3 4 0\n"
               "set-dimension-text \"<> \u00b1 0.1\"\n"
               "linear-dimension-3 x 0 0 0  3.25 4 0  0 9 0\n"
               "aligned-dimension-3 0 0 0  3 4 0  0 9 0\n"
               "set-dimension-text \"SR<>\"\n"
               "radius-dimension-3 0 0 0  3 4 0\n"
               "set-dimension-text \"<> deg\"\n"
               "angle-dimension-3 1 1 1  2 1 1  1 5 1  3\n"
               "leader-3 0 0 0 \"<>\"\n"
               "set-dimension-text \"\"\n"
               "radius-dimension-3 0 0 0  3 4 0\n"),
      (std::vector<std::string>{"\u00d8"
                                "5 H7",
                                "3.25 \u00b1 0.1", "5 \u00b1 0.1", "SR5", "90 deg", "<>", "R5"}));
  for (const char* const bad : {"H7", "<> <>", "<"}) {
    EXPECT_EQ(
        error_of_program(fmt::format("set-dimension-text \"{}\"\n", bad)),
        fmt::format("scene.draw:1:1: dimension text \"{}\": expected <> once, in place of the "
                    "measure",
                    bad));
  }
  EXPECT_NE(error_of_program("set-dimension-text <>\n").find("1:20: expected a text in quotation"),
            std::string::npos);
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  AnnotationStyle style;
  style.dimension_text = "<> \"H7\"";
  g.set_annotation_style(style);
  g.set_annotation_style(style);
  EXPECT_EQ(recording.str(), "set-dimension-text \"<> \\\"H7\\\"\"\n");
  EXPECT_EQ(replayed(recording.str()).looks().annotation, style);
}

/// So are the offsets of dimension lines.
TEST(Annotation, OffsetsAreInTheCoordinatesInForce) {
  const GraphicsSystem g = replayed(
      "scale-3 .5 .25 1\nrotate-z-3 90\nopen-segment 1\n"
      "linear-dimension-3 x  0 0 0  1 1 0  9 1 0\n"
      "aligned-dimension-3  0 0 0  0 1 0  1 0 0\nclose-segment\n");
  const auto kept = g.display_file().segment(1).entered()->annotations();
  ASSERT_EQ(kept.size(), 2u);
  const auto expect_at = [&](std::size_t k, std::size_t point, double x, double y) {
    EXPECT_NEAR(kept[k].points[point].x, 0.5 + 0.5 * x, 1e-12) << k << " " << point;
    EXPECT_NEAR(kept[k].points[point].y, 0.5 + 0.5 * y, 1e-12) << k << " " << point;
  };
  expect_at(0, 1, -0.25, 0.5);
  expect_at(0, 2, -0.25, 0.0);
  expect_at(0, 3, -0.25, 0.5);
  expect_at(1, 1, -0.25, 0.0);
  expect_at(1, 2, 0.0, 0.5);
  expect_at(1, 3, -0.25, 0.5);
}

TEST(Annotation, LinesOfTheRecording) {
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem g;
  g.set_recorder(&recorder);
  g.open_segment(1);
  g.annotate(Leader{{0, 0, 0.5}, "a \"b\""});
  g.annotate(Leader{{0, 0, 0}, "c", Point2(-1, 2.5)});
  g.annotate(Balloon{{0, 0, 0}, 3});
  g.annotate(Balloon{{0, 0, 0}, 3, "Nut"});
  g.annotate(Balloon{{0, 0, 0}, 3, "", Point2(1, 2)});
  g.set_annotation_style({2.5, AnnotationStyle::Unit::pixels, AnnotationStyle::Ends::dot, 1,
                          AnnotationStyle::Placement::automatic});
  g.annotate(LinearDimension{LinearDimension::Axis::y, {0, 0, 0}, {0, 0.5, 0}, {0.25, 0, 0}});
  g.annotate(AlignedDimension{{0, 0, 0}, {0, 0.5, 0}, {0.25, 0, 0}});
  g.annotate(DiameterDimension{{0, 0, 0}, {0, 0.5, 0}});
  g.annotate(RadiusDimension{{0, 0, 0}, {0, 0.5, 0}});
  g.annotate(AngleDimension{{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}, 0.75});
  g.annotate(Title{"t"});
  g.annotate(PartsList{});
  g.close_segment();
  EXPECT_EQ(recording.str(),
            "open-segment 1\n"
            "leader-3 0 0 0.5 \"a \\\"b\\\"\"\n"
            "leader-3 0 0 0 \"c\" -1 2.5\n"
            "balloon-3 0 0 0 3\n"
            "balloon-3 0 0 0 3 \"Nut\"\n"
            "balloon-3 0 0 0 3 \"\" 1 2\n"
            "set-annotation-size 2.5 px\n"
            "set-annotation-ends dot\n"
            "set-annotation-decimals 1\n"
            "set-annotation-placement auto\n"
            "linear-dimension-3 y  0 0 0  0 0.5 0  0.25 0 0\n"
            "aligned-dimension-3 0 0 0  0 0.5 0  0.25 0 0\n"
            "diameter-dimension-3 0 0 0  0 0.5 0\n"
            "radius-dimension-3 0 0 0  0 0.5 0\n"
            "angle-dimension-3 0 0 0  1 0 0  0 0.5 0  0.75\n"
            "title \"t\"\n"
            "parts-list bottom-right\n"
            "close-segment\n");
  EXPECT_EQ(dump_of(recording.str()), dump(g.display_file()));
}

// ---- Segments and views -------------------------------------------------------------------------

constexpr std::string_view kTwoSegments =
    "set-hidden-line-removal on\nset-hidden-method bsp\nset-hidden-scope all\n"
    "open-segment 1\n"
    "leader-3 0 0 -0.5 \"behind\"\n"
    "polygon-abs-3 -.5 -.5 0  .5 -.5 0  .5 .5 0  -.5 .5 0\n"
    "close-segment\n"
    "open-segment 2\n"
    "set-line-style solid 0 0 1\n"
    "aligned-dimension-3 -.5 0 .5  .5 0 .5  0 .25 0\n"
    "close-segment\n";

/// Nothing hides it, it stays with its segment, and an image transformation moves its points.
TEST(Annotation, FollowsASortedScene) {
  GraphicsSystem g = replayed(kTwoSegments);
  g.set_image_translation(2, 0.25, 0);
  SortedDisplayFile sorted;
  const std::string text = dump(sorted.update(g, HiddenMethod::bsp, {}));
  const std::string_view expected =
      "line 0.25 0.75 0.75\n"
      "annotation leader 3.5 mm arrow entered 0 0 0 10.5 10.5 0.5 0.5 0.625 \"behind\"\n"
      "segment 2 visible\n"
      "annotation linear 3.5 mm arrow entered 0 0 1 0 0 0.5 0.5 0.875 1 0.5 0.875 0.5 0.625 0.875 "
      "1 "
      "0.625 0.875 \"1\"\n"
      "end\n";
  EXPECT_TRUE(text.ends_with(expected)) << text;
}

/// Marks as numbers, for comparisons.
std::string in_words(const std::vector<AnnotationMark>& marks) {
  std::string words;
  for (const AnnotationMark& mark : marks) {
    words += fmt::format("{} {} {}:", static_cast<int>(mark.kind), mark.segment, mark.width);
    for (const Point2& p : mark.points) words += fmt::format(" {:.9f} {:.9f}", p.x, p.y);
    words += fmt::format(" {} {:.9f} {:.9f} {}\n", mark.text.characters, mark.text.anchor.x,
                         mark.text.anchor.y, mark.text.turn);
  }
  return words;
}

constexpr AnnotationPage kPage{512, 512, kPixelsOfMillimetre};

/// The display file, the viewed scene and the retained scene have the same, in any view.
TEST(Annotation, IsRetained) {
  GraphicsSystem g;
  RetainedScene scene;
  g.retain(&scene);
  replay(kTwoSegments, "scene.draw", g);
  const std::string drawn = in_words(annotation_marks(g.display_file(), kPage));
  EXPECT_NE(drawn.find("behind"), drawn.npos);
  EXPECT_EQ(in_words(annotation_marks(ViewedScene(g.display_file()), kPage)), drawn);
  SceneViewer viewer(scene, g.display_file());
  EXPECT_EQ(in_words(annotation_marks(viewer.view({.view = g.view()}), kPage)), drawn);
  EXPECT_EQ(dump(WorldViews(scene, g.display_file()).as_drawn().display_file),
            dump(g.display_file()));
  g.set_image_translation(2, 0.25, 0);
  const std::string moved = in_words(annotation_marks(g.display_file(), kPage));
  EXPECT_NE(moved, drawn);
  EXPECT_EQ(in_words(annotation_marks(viewer.view({.view = g.view()}), kPage)), moved);
  const View other = look_at({3, 2, 6}, {0, 0, 0});
  const std::string turned = in_words(annotation_marks(viewer.view({.view = other}), kPage));
  EXPECT_NE(turned, drawn);
  EXPECT_EQ(in_words(annotation_marks(viewer.display_file(other), kPage)), turned);
  g.set_visibility(1, false);
  EXPECT_EQ(in_words(annotation_marks(g.display_file(), kPage)).find("behind"), drawn.npos);
}

/// Points of the model outside of the view volume; a dimension line may be outside.
TEST(Annotation, IsDrawnWhereItsPointsAreInTheView) {
  EXPECT_EQ(texts_of("leader-3 60 0 0 \"beside\"\n"
                     "aligned-dimension-3 0 0 0  60 0 0  0 9 0\n"
                     "aligned-dimension-3 0 0 0  20 0 0  0 90 0\n"
                     "leader-3 0 0 0 \"inside\"\n"),
            (std::vector<std::string>{"20", "inside"}));
  const std::string perspective = dump_of(
      "set-perspective 0 0 5\nopen-segment 1\n"
      "aligned-dimension-3 -.5 0 0  .5 0 0  0 0 5.5\n"  // at the eye and behind it
      "aligned-dimension-3 -.5 0 0  .5 0 0  0 0 1\nclose-segment\n");
  EXPECT_EQ(perspective.find("annotation"), perspective.rfind("annotation"));
}

}  // namespace
}  // namespace displayfile
