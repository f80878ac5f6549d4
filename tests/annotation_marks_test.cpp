// The lines and texts of annotation on a page.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/annotation/annotation_marks.h"
#include "tests/replayed.h"

namespace displayfile {
namespace {

using namespace test;
using Kind = AnnotationMark::Kind;

/// A picture of 1000 x 1000 pixels of a window from (0, 0) to (1000, 1000): a unit is a pixel. The
/// letters are 14 pixels high, so lines are 1 wide.
std::vector<AnnotationMark> marks_of(std::string_view program) {
  const GraphicsSystem g = replayed(
      fmt::format("set-window 0 1000 0 1000\nset-view-depth -100 100\nset-annotation-size 14 px\n"
                  "open-segment 7\n{}close-segment\n",
                  program));
  return annotation_marks(g.display_file(), {1000, 1000, kPixelsOfMillimetre});
}

/// Sentences, separated by line ends.
std::string faults_of(std::string_view program) {
  const GraphicsSystem g = replayed(
      fmt::format("set-window 0 1000 0 1000\nset-view-depth -100 100\nset-annotation-size 14 px\n"
                  "open-segment 7\n{}close-segment\n",
                  program));
  return fmt::format(
      "{}",
      fmt::join(annotation_faults(g.display_file(), {1000, 1000, kPixelsOfMillimetre}), "\n"));
}

std::vector<AnnotationMark> of_kind(const std::vector<AnnotationMark>& marks, Kind kind) {
  std::vector<AnnotationMark> some;
  for (const AnnotationMark& mark : marks) {
    if (mark.kind == kind) some.push_back(mark);
  }
  return some;
}

void expect_near(const Point2& actual, const Point2& expected) {
  EXPECT_LT(glm::distance(actual, expected), 1e-6)
      << actual.x << " " << actual.y << ", expected " << expected.x << " " << expected.y;
}

Point2 anchor_of(const AnnotationMark& text) {
  return {1000.0 * text.text.anchor.x, 1000.0 * text.text.anchor.y};
}

/// ISO 129-1: a gap and an overshoot of 8 line widths; the number above the middle of the line.
TEST(AnnotationMarks, LinearDimension) {
  const auto marks = marks_of("linear-dimension-3 x 100 100 0  400 150 0  0 200 0\n");
  const auto lines = of_kind(marks, Kind::line), areas = of_kind(marks, Kind::area),
             texts = of_kind(marks, Kind::text);
  ASSERT_EQ(lines.size(), 3u);
  ASSERT_EQ(areas.size(), 2u);
  ASSERT_EQ(texts.size(), 1u);
  expect_near(lines[0].points[0], {100, 108});
  expect_near(lines[0].points[1], {100, 308});
  expect_near(lines[1].points[0], {400, 158});
  expect_near(lines[1].points[1], {400, 308});
  for (const Point2& p : lines[2].points) EXPECT_NEAR(p.y, 300.0, 1e-6);
  expect_near(areas[0].points[0], {100, 300});
  expect_near(areas[1].points[0], {400, 300});
  EXPECT_GT(areas[0].points[1].x, 110.0);
  EXPECT_LT(areas[1].points[1].x, 390.0);
  EXPECT_EQ(texts[0].text.characters, "300");
  EXPECT_EQ(texts[0].text.turn, 0.0);
  expect_near(anchor_of(texts[0]), {250, 305.6});
  EXPECT_EQ(texts[0].text.style.alignment, TextStyle::Alignment::centre);
  for (const AnnotationMark& mark : marks) {
    EXPECT_EQ(mark.segment, 7);
    EXPECT_NEAR(mark.width, 1.0, 1e-12);
  }
}

/// Numbers are read from the bottom or from the right, and stand above their line.
TEST(AnnotationMarks, NumbersAreReadable) {
  for (int degrees = 0; degrees < 360; degrees += 10) {
    const double angle = degrees * 3.14159265358979 / 180.0;
    const Point2 along(std::cos(angle), std::sin(angle));
    const auto texts =
        of_kind(marks_of(fmt::format("aligned-dimension-3 500 500 0  {} {} 0  0 0 0\n",
                                     500 + 300 * along.x, 500 + 300 * along.y)),
                Kind::text);
    ASSERT_EQ(texts.size(), 1u);
    const double turn = texts[0].text.turn;
    EXPECT_GT(turn, -74.9) << degrees;
    EXPECT_LT(turn, 105.1) << degrees;
    EXPECT_NEAR(std::remainder(turn - degrees, 180.0), 0.0, 1e-5);
    const Point2 aside = anchor_of(texts[0]) - Point2(500.0) - 150.0 * along;
    const double turned = turn * 3.14159265358979 / 180.0;
    EXPECT_NEAR(glm::dot(aside, Point2(-std::sin(turned), std::cos(turned))), 5.6, 1e-4);
  }
}

/// Where there is no room arrows come from outside, and the number stands beyond the last end.
TEST(AnnotationMarks, DimensionsWithoutRoom) {
  const auto small = marks_of("aligned-dimension-3 100 100 0  120 100 0  0 50 0\n");
  const auto areas = of_kind(small, Kind::area), texts = of_kind(small, Kind::text);
  ASSERT_EQ(areas.size(), 2u);
  expect_near(areas[0].points[0], {100, 150});
  EXPECT_LT(areas[0].points[1].x, 90.0);
  expect_near(areas[1].points[0], {120, 150});
  EXPECT_GT(areas[1].points[1].x, 130.0);
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_GT(anchor_of(texts[0]).x, 145.0);
  const auto narrow = marks_of(
      "set-annotation-decimals 9\n"
      "aligned-dimension-3 100 100 0  150.123456789 100 0  0 50 0\n");
  EXPECT_GT(of_kind(narrow, Kind::area)[0].points[1].x, 110.0);  // arrows have room
  EXPECT_GT(anchor_of(of_kind(narrow, Kind::text)[0]).x, 200.0);
  // Seen end on there is nothing to draw.
  EXPECT_TRUE(marks_of("aligned-dimension-3 100 100 0  100 100 50  0 50 0\n").empty());
  EXPECT_TRUE(marks_of("radius-dimension-3 100 100 0  100 100 50\n").empty());
}

TEST(AnnotationMarks, RadiusAndDiameter) {
  const auto radius = marks_of("radius-dimension-3 500 500 0  500 300 0\n");
  const auto arrows = of_kind(radius, Kind::area);
  ASSERT_EQ(arrows.size(), 1u);
  expect_near(arrows[0].points[0], {500, 300});
  EXPECT_GT(arrows[0].points[1].y, 305.0);
  EXPECT_EQ(of_kind(radius, Kind::text)[0].text.turn, 90.0);
  const auto small = marks_of("radius-dimension-3 500 500 0  510 500 0\n");
  const auto from_outside = of_kind(small, Kind::area);
  expect_near(from_outside[0].points[0], {510, 500});
  EXPECT_GT(from_outside[0].points[1].x, 515.0);
  EXPECT_GT(anchor_of(of_kind(small, Kind::text)[0]).x, 530.0);
  const auto diameter =
      of_kind(marks_of("diameter-dimension-3 300 500 0  700 500 0\n"), Kind::area);
  ASSERT_EQ(diameter.size(), 2u);
  expect_near(diameter[0].points[0], {300, 500});
  expect_near(diameter[1].points[0], {700, 500});
}

/// An arc about the vertex, from one direction to the other; extension lines where it is beyond the
/// points.
TEST(AnnotationMarks, Angle) {
  const auto marks = marks_of("angle-dimension-3 100 100 0  200 100 0  100 900 0  400\n");
  const auto lines = of_kind(marks, Kind::line), areas = of_kind(marks, Kind::area);
  ASSERT_EQ(lines.size(), 2u);
  expect_near(lines[0].points[0], {208, 100});
  expect_near(lines[0].points[1], {508, 100});
  for (const Point2& p : lines[1].points) EXPECT_NEAR(glm::distance(p, {100, 100}), 400.0, 0.5);
  ASSERT_EQ(areas.size(), 2u);
  expect_near(areas[0].points[0], {500, 100});
  expect_near(areas[1].points[0], {100, 500});
  const auto text = of_kind(marks, Kind::text)[0];
  EXPECT_EQ(text.text.characters, "90\u00b0");
  EXPECT_EQ(text.text.turn, 0.0);
  EXPECT_GT(glm::distance(anchor_of(text), {100, 100}), 405.0);
}

/// A text right of the line's end or left of it; an arrow or a dot at the model.
TEST(AnnotationMarks, Leader) {
  const auto right = marks_of("leader-3 100 100 0 \"abc\" 60 80\n");
  const auto lines = of_kind(right, Kind::line);
  ASSERT_EQ(lines.size(), 2u);
  expect_near(lines[0].points[0], {160, 180});
  expect_near(lines[1].points[1], {174, 180});
  expect_near(of_kind(right, Kind::area)[0].points[0], {100, 100});
  auto text = of_kind(right, Kind::text)[0];
  EXPECT_EQ(text.text.style.alignment, TextStyle::Alignment::left);
  expect_near(anchor_of(text), {179.6, 173});
  const auto left = marks_of("set-annotation-ends dot\nleader-3 100 100 0 \"abc\" -60 80\n");
  text = of_kind(left, Kind::text)[0];
  EXPECT_EQ(text.text.style.alignment, TextStyle::Alignment::right);
  expect_near(anchor_of(text), {20.4, 173});
  const auto dot = of_kind(left, Kind::area);
  ASSERT_EQ(dot.size(), 1u);
  for (const Point2& p : dot[0].points) EXPECT_NEAR(glm::distance(p, {100, 100}), 3.08, 1e-6);
  EXPECT_EQ(marks_of("leader-3 100 100 0 \"abc\" 0 0\n").size(), 2u);  // the landing and the text
}

/// A circle about the number, which hides the figure; the line points to its centre.
TEST(AnnotationMarks, Balloon) {
  const auto marks = marks_of("balloon-3 100 100 0 7 \"\" 300 400\n");
  const auto blanks = of_kind(marks, Kind::blank), lines = of_kind(marks, Kind::line);
  ASSERT_EQ(blanks.size(), 1u);
  ASSERT_EQ(lines.size(), 2u);
  const double radius = glm::distance(blanks[0].points[0], {400, 500});
  for (const Point2& p : blanks[0].points) {
    EXPECT_NEAR(glm::distance(p, {400, 500}), radius, 1e-6);
  }
  expect_near(lines[0].points[0], Point2(400, 500) - radius * Point2(0.6, 0.8));
  EXPECT_TRUE(lines[1].closed);
  EXPECT_EQ(lines[1].points, blanks[0].points);
  expect_near(anchor_of(of_kind(marks, Kind::text)[0]), {400, 493});
  const auto wide = of_kind(marks_of("balloon-3 100 100 0 1234 \"\" 300 400\n"), Kind::blank);
  EXPECT_GT(glm::distance(wide[0].points[0], {400, 500}), 1.5 * radius);
}

/// Balloons with the same number are one row; the list is in its corner.
TEST(AnnotationMarks, PartsList) {
  const std::string balloons =
      "balloon-3 500 500 0 12 \"Nut\"\nballoon-3 500 600 0 3 \"Shaft\"\n"
      "balloon-3 500 700 0 12 \"Nut\"\nballoon-3 500 800 0 4\n";
  for (const bool top : {false, true}) {
    for (const bool right : {false, true}) {
      std::vector<AnnotationMark> list;
      for (const AnnotationMark& mark :
           marks_of(balloons + fmt::format("parts-list {}-{}\n", top ? "top" : "bottom",
                                           right ? "right" : "left"))) {
        if (mark.annotation == 4) list.push_back(mark);
      }
      std::string cells;
      for (const AnnotationMark& text : of_kind(list, Kind::text)) {
        cells += text.text.characters + " ";
      }
      EXPECT_EQ(cells, "ITEM PART QTY 3 Shaft 1 12 Nut 2 ");
      const auto blank = of_kind(list, Kind::blank);
      ASSERT_EQ(blank.size(), 1u);
      for (const Point2& p : blank[0].points) {
        EXPECT_GT(std::abs(p.x - (right ? 0.0 : 1000.0)), 500.0);
        EXPECT_GT(std::abs(p.y - (top ? 0.0 : 1000.0)), 500.0);
      }
    }
  }
  EXPECT_TRUE(marks_of("parts-list\n").empty());
}

TEST(AnnotationMarks, TitleAndUnits) {
  const auto title = marks_of("title \"A vice\"\n");
  ASSERT_EQ(title.size(), 1u);
  EXPECT_NEAR(anchor_of(title[0]).x, 500.0, 1e-9);
  EXPECT_GT(anchor_of(title[0]).y, 950.0);
  EXPECT_LT(anchor_of(title[0]).y + 20.02, 1000.0);
  const GraphicsSystem g = replayed(
      "open-segment 1\nset-annotation-size 2 mm\n"
      "leader-3 0 0 0 \"a\" 3 0\nclose-segment\n");
  for (const double millimetre : {1.0, 5.0}) {
    const auto marks = annotation_marks(g.display_file(), {1000, 500, millimetre});
    const auto text = of_kind(marks, Kind::text)[0];
    EXPECT_NEAR(text.text.style.size * 500.0 * 0.72, 2.0 * millimetre, 1e-9);
    EXPECT_NEAR(of_kind(marks, Kind::line).back().points[0].x, 500.0 + 3.0 * millimetre, 1e-9);
  }
}

std::vector<std::string> lines_of_title(std::string_view program) {
  std::vector<std::string> lines;
  for (const AnnotationMark& mark : marks_of(program)) {
    if (mark.kind == Kind::text) lines.push_back(mark.text.characters);
  }
  return lines;
}

/// A title wider than the picture is broken at blanks; only where that is not enough it becomes
/// smaller, and is then named if it still reaches beyond.
TEST(AnnotationMarks, ALongTitleIsInThePicture) {
  const std::string word(30, 'x'), long_word(60, 'x'), endless(200, 'x');
  EXPECT_EQ(lines_of_title("title \"A  vice\"\n"), (std::vector<std::string>{"A  vice"}));
  EXPECT_EQ(lines_of_title(fmt::format("title \"{0}  {0} {0}\"\n", word)),
            (std::vector<std::string>{word, word, word}));
  EXPECT_EQ(lines_of_title(fmt::format("title \"{0} a\"\n", long_word)),
            (std::vector<std::string>{long_word + " a"}));
  const auto marks = marks_of(fmt::format("title \"{0} {0} {0}\"\n", word));
  for (const AnnotationMark& mark : marks) {
    EXPECT_NEAR(mark.text.style.size * 1000.0 * 0.72, 1.43 * 14.0, 1e-9);
    EXPECT_NEAR(anchor_of(mark).x, 500.0, 1e-9);
  }
  EXPECT_GT(anchor_of(marks[0]).y, anchor_of(marks[1]).y + 1.43 * 14.0);
  const auto small = marks_of(fmt::format("title \"{0} a\"\n", long_word));
  EXPECT_NEAR(small[0].text.style.size * 1000.0 * 0.72, 14.0, 1e-9);
  EXPECT_EQ(faults_of(fmt::format("title \"{0} {0} {0}\"\n", word)), "");
  EXPECT_EQ(faults_of(fmt::format("title \"{0}\"\n", endless)),
            "annotation reaches beyond the picture and is cut off: the title: expected larger "
            "paper, a larger window or a smaller scale");
}

/// A title that covers the figure becomes smaller if that helps, and is named otherwise, where
/// annotation is placed automatically.
TEST(AnnotationMarks, ATitleOverTheFigure) {
  const auto program = [](std::string_view placement, double top) {
    return fmt::format(
        "set-annotation-placement {0}\npolygon-abs-3 100 100 0  900 100 0  900 {1} 0  100 {1} 0\n"
        "title \"A vice\"\n",
        placement, top);
  };
  const auto size = [&](std::string_view placement, double top) {
    return marks_of(program(placement, top)).back().text.style.size * 1000.0 * 0.72 / 14.0;
  };
  EXPECT_NEAR(size("auto", 900.0), 1.43, 1e-9);
  EXPECT_NEAR(size("auto", 960.0), 1.0, 1e-9);
  EXPECT_NEAR(size("entered", 960.0), 1.43, 1e-9);
  EXPECT_EQ(faults_of(program("auto", 960.0)), "");
  EXPECT_NEAR(size("auto", 990.0), 1.43, 1e-9);
  EXPECT_EQ(faults_of(program("auto", 990.0)),
            "annotation placement auto has no room for the title, which may cover the figure: "
            "expected larger paper, a larger window or a smaller scale");
}

/// Nothing is lost from the parts list: a number with two names has two rows.
TEST(AnnotationMarks, PartsWithSeveralNamesAndNumbers) {
  const std::string balloons =
      "balloon-3 300 300 0 1 \"Screw\"\nballoon-3 350 300 0 1 \"Nut\"\n"
      "balloon-3 400 300 0 2 \"Screw\"\nballoon-3 450 300 0 1 \"Screw\"\n"
      "balloon-3 500 300 0 3 \"Pin\"\nballoon-3 550 300 0 3 \"Pin\"\n";
  std::string list;
  for (const AnnotationMark& mark : marks_of(balloons + "parts-list\n")) {
    if (mark.annotation == 6 && mark.kind == Kind::text) list += mark.text.characters + " ";
  }
  EXPECT_EQ(list, "ITEM PART QTY 1 Screw 2 1 Nut 1 2 Screw 1 3 Pin 2 ");
  EXPECT_EQ(faults_of(balloons + "parts-list\n"),
            "the parts list has several names for a number: 1 is \"Nut\" and \"Screw\": expected "
            "one for each\nthe parts list has several numbers for a name: \"Screw\" is 1 and 2: "
            "expected one for each");
  EXPECT_EQ(faults_of(balloons), "");  // no list shows them
}

/// Far outside of the picture it is left out, so that devices get no coordinates beyond their
/// range.
TEST(AnnotationMarks, NothingFarOutside) {
  EXPECT_FALSE(marks_of("aligned-dimension-3 100 100 0  400 100 0  0 10000 0\n").empty());
  EXPECT_TRUE(marks_of("aligned-dimension-3 100 100 0  400 100 0  0 20000 0\n").empty());
  EXPECT_TRUE(marks_of("leader-3 100 100 0 \"a\" 20000 0\n").empty());
}

}  // namespace
}  // namespace displayfile
