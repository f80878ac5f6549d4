// Dimensions, leaders, balloons, titles and parts lists of drawing programs on sheets.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/sheet_fixture.h"

namespace {

class SheetAnnotation : public SheetCommandTest {
 protected:
  std::vector<Stroke> strokes(const std::string& layer) {
    return strokes_of(path_of("s.svg", layer));
  }
  void draw(const std::string& arguments) {
    ASSERT_EQ(run("sheet -o s.svg " + arguments), 0) << err_;
    EXPECT_EQ(err_, "");
  }
};

/// Dimensions of a program are drawn where they show their length, in millimetres of the paper.
TEST_F(SheetAnnotation, DimensionsAreInTheViewsThatShowThem) {
  const std::string box = "open-segment 1\nbox-3 0 60 0 40 0 30\n";
  write("width.draw", box + "linear-dimension-3 x 0 0 30 60 0 30 0 -10 0\nclose-segment\n");
  draw("width.draw --scale 1:1");
  const double between_arrows = 60.0 - 0.9 * 3.5;
  const auto level = [&](double length) {
    const auto all = strokes("DIMENSION");
    return std::ranges::count_if(all, [&](const Stroke& s) {
      return std::abs(std::abs(s[2] - s[0]) - length) < 1e-3 && std::abs(s[3] - s[1]) < 1e-3;
    });
  };
  const auto upright = [&](double length) {
    const auto all = strokes("DIMENSION");
    return std::ranges::count_if(all, [&](const Stroke& s) {
      return std::abs(std::abs(s[3] - s[1]) - length) < 1e-3 && std::abs(s[2] - s[0]) < 1e-3;
    });
  };
  EXPECT_EQ(level(between_arrows), 1);
  EXPECT_EQ(upright(10.0), 2);  // extension lines: a gap, and as much beyond
  const auto has_text = [&](const std::string& characters) {
    const auto all = texts("s.svg");
    return std::ranges::any_of(all, [&](const Text& t) { return t.characters == characters; });
  };
  EXPECT_TRUE(has_text("60"));
  // The front view's lower edge is 10 mm above the line.
  double line = 0.0, edge = 0.0;
  for (const Stroke& s : strokes("DIMENSION")) line = std::max(line, s[1]);
  for (const Stroke& s : strokes("VISIBLE")) edge = std::max({edge, s[1], s[3]});
  EXPECT_GT(line, edge + 9.0);
  // Along the depth the top view shows it, read from the right; the angle stands in the front view.
  write("depth.draw", box + "linear-dimension-3 z 60 40 0 60 40 30 10 0 0\n" +
                          "angle-dimension-3 0 0 30 60 0 30 0 40 30 15\nclose-segment\n");
  draw("depth.draw --scale 1:1");
  EXPECT_EQ(upright(30.0 - 0.9 * 3.5), 1);
  EXPECT_NE(read(folder_ / "s.svg").find("transform=\"rotate(-90 "), std::string::npos);
  EXPECT_TRUE(has_text("90\u00b0"));
  // The circle's diameter is where the circle is seen, though the side view is as parallel.
  write("hole.draw",
        box + "cylinder-3 30 20 30  8 10 32\ndiameter-dimension-3 22 20 40  38 20 40\n" +
            "set-annotation-placement auto\nlinear-dimension-3 y 0 0 0 0 40 0 -1 0 0\n" +
            "close-segment\n");
  draw("hole.draw --scale 1:1");
  EXPECT_EQ(level(16.0 - 0.9 * 3.5), 1);
  EXPECT_EQ(upright(40.0 - 0.9 * 3.5), 1);
}

/// Letters of sections keep clear of numbers.
TEST_F(SheetAnnotation, DimensionsAndSectionsKeepApart) {
  write("turned.draw",
        "open-segment 1\nturn-3 72  9 -14  42 -14  42 14  9 14\n"
        "set-annotation-placement auto\nlinear-dimension-3 x -42 0 0  42 0 0  0 -1 0\n"
        "radius-dimension-3 0 0 0  0 42 0\nclose-segment\n");
  draw("turned.draw --scale 1:1 --section side=0");
  const std::vector<Text> all = texts("s.svg");
  std::size_t letters = 0;
  for (const Text& letter : all) {
    if (letter.characters != "A") continue;
    ++letters;
    for (const Text& number : all) {
      if (number.characters != "84") continue;
      const bool beside = number.left() > letter.left() + letter.width() ||
                          letter.left() > number.left() + number.width();
      EXPECT_TRUE(beside || number.top() > letter.y || letter.top() > number.y)
          << letter.x << ' ' << letter.y << ' ' << number.x << ' ' << number.y;
    }
  }
  EXPECT_EQ(letters, 2u);
}

TEST_F(SheetAnnotation, DimensionsThatNoViewShowsAreNamed) {
  write("skew.draw",
        "open-segment 1\nbox-3 0 60 0 40 0 30\naligned-dimension-3 0 0 0 60 40 30 0 -9 0\n"
        "linear-dimension-3 x 0 0 30 60 0 30 0 -900 0\nleader-3 0 0 0 \"a\" -300 0\n"
        "balloon-3 30 40 30 4 \"\" 0 70\nclose-segment\n");
  ASSERT_EQ(run("sheet -o s.svg skew.draw --scale 1:1"), 0) << err_;
  EXPECT_NE(err_.find("s.svg: dimension 78.1 is parallel to no view: left out\n"), err_.npos)
      << err_;
  EXPECT_NE(err_.find("s.svg: dimension 60 reaches beyond the sheet's frame\n"), err_.npos) << err_;
  EXPECT_NE(err_.find("s.svg: leader \"a\" reaches beyond the sheet's frame\n"), err_.npos) << err_;
  EXPECT_NE(err_.find("s.svg: balloon 4 reaches over another view\n"), err_.npos) << err_;
}

TEST_F(SheetAnnotation, DimensionsAreALayerInDxf) {
  write("width.draw",
        "open-segment 1\nbox-3 0 60 0 40 0 30\nlinear-dimension-3 y 0 0 0 0 40 0 -10 0 0\n"
        "close-segment\n");
  if (!can_run("sheet -o s.dxf width.draw --scale 1:1", "dxflib")) GTEST_SKIP() << err_;
  const std::string dxf = read(folder_ / "s.dxf");
  const std::size_t text = dxf.find("AcDbText", dxf.find("ENTITIES"));
  ASSERT_NE(text, dxf.npos);
  EXPECT_NE(dxf.substr(text - 80, 80).find("DIMENSION"), dxf.npos);
  // Its characters, turned by 90 degrees.
  EXPECT_NE(dxf.find("\n  1\n40\n 50\n90\n", text), dxf.npos);
  ASSERT_EQ(run("sheet -o s.pdf width.draw --scale 1:1 --font hershey"), 0) << err_;
}

/// Leaders stand in the first view in which their point is seen.
TEST_F(SheetAnnotation, LeadersAreInTheViewThatShowsTheirPoint) {
  const auto at = [&](const std::string& point, const std::string& arguments = "") {
    write("box.draw", "open-segment 1\nbox-3 0 60 0 40 0 30\nbox-3 10 20 10 20 10 20\nleader-3 " +
                          point + " \"here\" 5 4\nclose-segment\n");
    draw("box.draw --scale 1:1 " + arguments);
    const auto all = texts("s.svg");
    const auto text = std::ranges::find(all, "here", &Text::characters);
    EXPECT_NE(text, all.end());
    double left = 1e9, low = 0.0;  // the front view's corner
    for (const Stroke& s : strokes("VISIBLE")) {
      left = std::min(left, s[0]);
      low = std::max({low, s[1], s[3]});
    }
    // The point, by the text that begins a landing and a gap away from the leader's end.
    const double x = text->x - (1.0 + 0.4) * 3.5 - 5.0 - left;
    const double y = low - (text->y - 0.5 * 3.5 + 4.0);
    return std::array{x, y};
  };
  EXPECT_NEAR(at("30 25 30")[0], 30.0, 1e-3);
  EXPECT_NEAR(at("30 25 30")[1], 25.0, 1e-3);
  const auto [top_x, top_y] = at("30 40 10");
  EXPECT_NEAR(top_x, 30.0, 1e-3);
  EXPECT_GT(top_y, 40.0 + 12.0);
  const auto [side_x, side_y] = at("60 25 10");
  EXPECT_GT(side_x, 60.0 + 12.0);
  EXPECT_NEAR(side_y, 25.0, 1e-3);
  // A hundredth of the part's size is no depth; within the part it is where least lies before it.
  EXPECT_NEAR(at("30 25 29.5")[1], 25.0, 1e-3);
  EXPECT_NEAR(at("30 25 28")[1], 25.0, 1e-3);
  EXPECT_GT(at("30 37 10")[1], 40.0 + 12.0);
  // A section shows points in its plane, and not those before it.
  EXPECT_NEAR(at("15 15 20")[1], 15.0, 12.0);
  EXPECT_NEAR(at("40 25 12", "--section front=12")[1], 25.0, 1e-3);
  EXPECT_GT(at("40 40 25", "--section front=12")[1], 40.0 + 12.0);
  EXPECT_GT(at("60 25 30", "--section front=12")[0], 60.0 + 12.0);
}

/// A part that a section leaves whole shows its points before the plane.
TEST_F(SheetAnnotation, WholePartsShowTheirPointsInSections) {
  write("ring.draw", "open-segment 1\nturn-3 48  10 -10  30 -10  30 10  10 10\nclose-segment\n");
  write("shaft.draw",
        "open-segment 1\ncylinder-3 0 0 -30 9 60 72\nballoon-3 0 -9 20  1 \"Shaft\" 0 15\n"
        "close-segment\n");
  const auto height = [&](const std::string& arguments) {
    draw("ring.draw shaft.draw --up z --scale 1:1 --section front=0 " + arguments);
    const auto all = texts("s.svg");
    return std::ranges::find(all, "1", &Text::characters)->y;
  };
  EXPECT_NE(height(""), height("--uncut shaft"));
}

/// Fifteen balloons and a text around the views of a part, each by itself.
TEST_F(SheetAnnotation, AutomaticLabelsKeepApart) {
  std::string program = "open-segment 1\nset-annotation-placement auto\n";
  for (int k = 0; k < 15; ++k) {
    const std::string x = std::to_string(10 * k), to = std::to_string(10 * k + 6);
    program += "box-3 " + x + " " + to + " 0 " + std::to_string(20 + k) + " 0 30\nballoon-3 " + x +
               (k % 3 == 0   ? " 10 30 "
                : k % 3 == 1 ? " 20 15 "
                             : " 5 30 ") +
               std::to_string(k + 1) + " \"Part\"\n";
  }
  write("row.draw", program + "leader-3 146 10 15 \"Ground\"\nclose-segment\n");
  draw("row.draw --section side=75");
  std::vector<Text> labels = texts("s.svg");
  std::erase_if(labels, [](const Text& text) { return !text.centred; });
  for (const Text& label : labels) {
    for (const char* layer : {"VISIBLE", "HATCH", "FRAME"}) {
      EXPECT_FALSE(is_drawn_over("s.svg", layer, 2, label)) << label.characters << ' ' << layer;
    }
    for (const Text& other : labels) {
      const bool meet = label.left() < other.left() + other.width() &&
                        other.left() < label.left() + label.width() && label.top() < other.y &&
                        other.top() < label.y;
      EXPECT_TRUE(&label == &other || !meet) << label.characters << ' ' << other.characters;
    }
  }
  expect_marks_apart("s.svg");  // of the section too
  EXPECT_EQ(std::ranges::count(labels, "A", &Text::characters), 2);
  for (const Text& letter : labels) {
    if (letter.characters != "A") continue;
    for (const Stroke& s : strokes("LEADER")) {
      for (double t = 0.0; t <= 1.0; t += 0.1) {
        const double x = s[0] + t * (s[2] - s[0]), y = s[1] + t * (s[3] - s[1]);
        EXPECT_FALSE(x > letter.left() && x < letter.left() + letter.width() && y > letter.top() &&
                     y < letter.y)
            << x << ' ' << y;
      }
    }
  }
  EXPECT_EQ(std::ranges::count(labels, "15", &Text::characters), 1);
  EXPECT_NE(read(folder_ / "s.svg").find(">Ground<"), std::string::npos);
}

TEST_F(SheetAnnotation, ABalloonCoversWhatIsBehindIt) {
  write("edge.draw",
        "open-segment 1\nbox-3 0 60 0 40 0 30\nballoon-3 30 0 30 1 \"\" 0 0\nclose-segment\n");
  draw("edge.draw --scale 1:1");
  double low = 0.0, left = 1e9, right = 0.0;
  for (const Stroke& s : strokes("VISIBLE")) low = std::max({low, s[1], s[3]});
  std::vector<double> ends;
  for (const Stroke& s : strokes("VISIBLE")) {
    if (s[1] == low && s[3] == low) ends.insert(ends.end(), {s[0], s[2]});
  }
  for (const Stroke& s : strokes("LEADER")) {
    left = std::min(left, s[0]);
    right = std::max(right, s[2]);
  }
  std::ranges::sort(ends);  // of the front view's lower edge in two pieces, and of the side view's
  ASSERT_EQ(ends.size(), 6U);
  EXPECT_NEAR(ends[1], left, 1e-3);
  EXPECT_NEAR(ends[2], right, 1e-3);
  EXPECT_NEAR(right - left, 2.0 * 1.15 * 3.5, 0.02);
  // Nothing is left of lines that end behind it.
  write("corner.draw",
        "open-segment 1\nbox-3 0 60 0 40 0 30\nballoon-3 0 0 30 1 \"\" 0 0\nclose-segment\n");
  draw("corner.draw --scale 1:1");
  double x = 1e9, y = 0.0;  // its centre
  for (const Stroke& s : strokes("LEADER")) {
    x = std::min(x, s[0] + 1.15 * 3.5);
    y = std::max({y, s[1] - 1.15 * 3.5, s[3] - 1.15 * 3.5});
  }
  for (const Stroke& s : strokes("VISIBLE")) {
    EXPECT_GT(std::hypot(s[0] - x, s[1] - y), 1.14 * 3.5);
    EXPECT_GT(std::hypot(s[2] - x, s[3] - y), 1.14 * 3.5);
  }
}

/// A text that is longer than the views are apart stands above its view or below it.
TEST_F(SheetAnnotation, ALongTextKeepsOffOtherViews) {
  write("long.draw",
        "open-segment 1\nset-annotation-placement auto\nbox-3 0 60 0 40 0 30\n"
        "leader-3 57 20 30 \"Ground on this face and polished\"\nclose-segment\n");
  draw("long.draw --paper a4");
  const auto all = texts("s.svg");
  const auto text = std::ranges::find(all, "Ground on this face and polished", &Text::characters);
  ASSERT_NE(text, all.end());
  EXPECT_FALSE(is_drawn_over("s.svg", "VISIBLE", 2, *text));
}

TEST_F(SheetAnnotation, DotsAreFilled) {
  write("dot.draw",
        "open-segment 1\nbox-3 0 60 0 40 0 30\nset-annotation-ends dot\n"
        "leader-3 30 20 30 \"a\" 9 9\nclose-segment\n");
  draw("dot.draw --scale 1:1");
  double ink = 0.0;
  for (const Stroke& s : strokes("LEADER")) ink += std::hypot(s[2] - s[0], s[3] - s[1]);
  const double radius = 0.22 * 3.5, pi = std::acos(-1.0);
  const double leader = 9.0 * std::sqrt(2.0) + 3.5, around = 2.0 * pi * radius;
  EXPECT_GT((ink - leader - around) * 0.25, pi * radius * radius);
}

/// The title block has the title of a program, unless there is another one.
TEST_F(SheetAnnotation, TheTitleOfAProgramIsThatOfTheSheet) {
  write("a.draw", "open-segment 1\nbox-3 0 60 0 40 0 30\ntitle \"Cover\"\nclose-segment\n");
  write("b.draw", "open-segment 1\nbox-3 0 60 0 40 30 40\ntitle \"Lid\"\nclose-segment\n");
  const auto has_text = [&](const std::string& characters) {
    const auto all = texts("s.svg");
    return std::ranges::find(all, characters, &Text::characters) != all.end();
  };
  draw("a.draw");
  EXPECT_TRUE(has_text("Cover"));
  draw("a.draw b.draw --title Housing");
  EXPECT_TRUE(has_text("Housing"));
  EXPECT_FALSE(has_text("Cover"));
  ASSERT_EQ(run("sheet -o s.svg a.draw b.draw"), 0);
  EXPECT_TRUE(has_text("Cover"));
  EXPECT_EQ(err_, "title \"Lid\": left out: the title block has \"Cover\"\n");
}

/// The list of a program is where the sheet's own would be, with the numbers of the balloons.
TEST_F(SheetAnnotation, ThePartsListIsThatOfTheBalloons) {
  const std::string parts =
      "open-segment 1\nbox-3 0 60 0 40 0 30\nballoon-3 0 0 30 7 \"Plate\"\n"
      "balloon-3 60 0 30 3 \"Pin\"\nballoon-3 60 40 30 3 \"Pin\"\n";
  write("own.draw", parts + "parts-list\nclose-segment\n");
  write("none.draw", parts + "close-segment\n");
  const std::vector<std::string> list{"ITEM", "PART", "QTY", "3", "Pin", "2", "7", "Plate", "1"};
  const auto has_list = [&] {
    std::vector<std::string> words;
    for (const Text& text : texts("s.svg")) words.push_back(text.characters);
    return std::search(words.begin(), words.end(), list.begin(), list.end()) != words.end();
  };
  draw("own.draw");
  EXPECT_TRUE(has_list());
  draw("none.draw");
  EXPECT_FALSE(has_list());
  draw("none.draw --parts-list");
  EXPECT_TRUE(has_list());
  // A picture's list has the same heads.
  ASSERT_EQ(run("draw own.draw -o s.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "s.svg").find(">ITEM<"), std::string::npos);
  EXPECT_NE(read(folder_ / "s.svg").find(">QTY<"), std::string::npos);
  write("bare.draw", "open-segment 1\nbox-3 0 60 0 40 0 30\nparts-list\nclose-segment\n");
  ASSERT_EQ(run("sheet -o s.svg bare.draw"), 0);
  EXPECT_EQ(err_,
            "parts-list: left out: no balloon has a name: expected --parts-list for a list of the "
            "parts\n");
}

TEST_F(SheetAnnotation, NumbersWithSeveralNamesAreNamed) {
  write("two.draw",
        "open-segment 1\nbox-3 0 60 0 40 0 30\nballoon-3 0 0 30 1 \"Screw\"\n"
        "balloon-3 60 0 30 1 \"Nut\"\nparts-list\nclose-segment\n");
  ASSERT_EQ(run("sheet -o s.svg two.draw"), 0);
  EXPECT_EQ(err_,
            "the parts list has several names for a number: 1 is \"Nut\" and \"Screw\": expected "
            "one for each\n");
  const std::vector<Text> all = texts("s.svg");
  for (const char* name : {"Screw", "Nut"}) {
    EXPECT_EQ(std::ranges::count(all, name, &Text::characters), 1) << name;
  }
}

/// Lines and texts, which a sheet does not draw, are counted once for each input.
TEST_F(SheetAnnotation, LinesAndTextsAreNamedAsLeftOut) {
  write("engraved.draw",
        "open-segment 1\nbox-3 0 60 0 40 0 10\nset-line-style solid black\n"
        "move-abs-3 10 10 10\nline-abs-3 50 30 10\nmove-abs-3 20 20 10\ntext \"PART 7\"\n"
        "close-segment\nopen-segment 2\nmove-abs-3 10 10 10\nline-abs-3 50 10 10\n"
        "close-segment\n");
  write("lines.draw",
        "open-segment 1\nmove-abs-3 0 0 0\nline-abs-3 1 1 1\nset-visibility 1 off\n"
        "close-segment\nopen-segment 2\ntext \"a\"\nclose-segment\n");
  ASSERT_EQ(run("sheet -o s.svg engraved.draw box.obj lines.draw"), 0);
  EXPECT_EQ(err_, "engraved.draw: left out: 2 lines, 1 text\nlines.draw: left out: 1 text\n");
}

TEST_F(SheetAnnotation, LeadersAreALayerInDxf) {
  write("left.draw",
        "open-segment 1\nbox-3 0 60 0 40 0 30\nleader-3 30 20 30 \"left\" -9 9\nclose-segment\n");
  draw("left.draw --scale 1:1");
  EXPECT_NE(read(folder_ / "s.svg").find(" text-anchor=\"end\">left<"), std::string::npos);
  ASSERT_EQ(run("sheet -o s.pdf left.draw --scale 1:1"), 0) << err_;
  if (!can_run("sheet -o s.dxf left.draw --scale 1:1", "dxflib")) GTEST_SKIP() << err_;
  const std::string dxf = read(folder_ / "s.dxf");
  const std::size_t text = dxf.find("AcDbText", dxf.find("ENTITIES"));
  ASSERT_NE(text, dxf.npos);
  EXPECT_NE(dxf.substr(text - 80, 80).find("LEADER"), dxf.npos);
  EXPECT_NE(dxf.find("\n 72\n2\n", text), dxf.npos);
}

}  // namespace
