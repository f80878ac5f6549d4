// Dimensions of drawing programs on sheets.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/sheet_fixture.h"

namespace {

class SheetDimensions : public SheetCommandTest {
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
TEST_F(SheetDimensions, DimensionsAreInTheViewsThatShowThem) {
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
TEST_F(SheetDimensions, DimensionsAndSectionsKeepApart) {
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

TEST_F(SheetDimensions, DimensionsThatNoViewShowsAreNamed) {
  write("skew.draw",
        "open-segment 1\nbox-3 0 60 0 40 0 30\naligned-dimension-3 0 0 0 60 40 30 0 -9 0\n"
        "linear-dimension-3 x 0 0 30 60 0 30 0 -900 0\nleader-3 0 0 0 \"a\"\nclose-segment\n");
  ASSERT_EQ(run("sheet -o s.svg skew.draw --scale 1:1"), 0) << err_;
  EXPECT_NE(err_.find("s.svg: dimension 78.1 is parallel to no view: left out\n"), err_.npos)
      << err_;
  EXPECT_NE(err_.find("s.svg: dimension 60 reaches beyond the sheet's frame\n"), err_.npos) << err_;
  EXPECT_NE(err_.find("skew.draw: left out: leaders, balloons, titles and parts lists"), err_.npos);
}

TEST_F(SheetDimensions, DimensionsAreALayerInDxf) {
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

}  // namespace
