// `displayfile sheet`, as its users meet it: views, lines, texts and files.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "tests/sheet_fixture.h"

namespace {

/// In messages of builds without them.
constexpr const char* kNeedsCgal = "needs CGAL, which this build was made without";
constexpr const char* kHasNoDxflib = "this build has no dxflib, which writes DXF";

TEST_F(SheetCommandTest, AMillimetreIsAMillimetreAtOneToOne) {
  ASSERT_EQ(run("sheet box.obj -o box.svg --scale 1:1"), 0) << err_;
  const auto all = numbers("box.svg", "VISIBLE");
  ASSERT_FALSE(all.empty());
  const double left = [&] {
    double x = 1e9;
    for (std::size_t i = 0; i < all.size(); i += 2) x = std::min(x, all[i]);
    return x;
  }();
  int widths = 0;
  for (std::size_t i = 0; i < all.size(); i += 2) widths += std::abs(all[i] - left - 60.0) < 1e-9;
  EXPECT_GE(widths, 4);  // two corners of the front view, two of the top view
}

TEST_F(SheetCommandTest, HiddenLinesUnderVisibleOnesAreLeftOut) {
  ASSERT_EQ(run("sheet box.obj -o box.svg --hidden-lines all"), 0) << err_;
  EXPECT_EQ(numbers("box.svg", "HIDDEN").size() / 2, 6U);  // three edges of the isometric view
}

/// The slope of a wedge is seen edge-on in the front view; its edges are behind the face that was
/// cut, and the middle one behind the block on it.
TEST_F(SheetCommandTest, EdgesOfAFaceSeenEdgeOnAreHidden) {
  write("ramp.draw",
        "open-segment 1\nbegin-solid difference\nbegin-solid union\nwedge-3 0 60 0 40 0 30\n"
        "box-3 20 30 20 30 0 40\nend-solid\nbox-3 -64 64 -64 25 -64 64\nend-solid\n"
        "close-segment\n");
  if (!can_run("sheet ramp.draw -o s.svg --up z --scale 1:1", kNeedsCgal)) GTEST_SKIP() << err_;
  int slopes = 0;
  for (const Stroke& stroke : strokes_of(path_of("s.svg", "HIDDEN"))) {
    slopes += std::abs(stroke[2] - stroke[0] - 10.0) < 1e-9 &&
              std::abs(std::abs(stroke[3] - stroke[1]) - 5.0) < 1e-9;
  }
  EXPECT_EQ(slopes, 1);
}

/// In the isometric view, whose coordinates are rounded, too: of the edges that go to the right and
/// up these are two of each box's upper and right faces, and the foot of the one on the other.
TEST_F(SheetCommandTest, TheFootOfASolidOnAnotherIsSeen) {
  write("two.draw", "open-segment 1\nbox-3 0 40 0 20 0 10\nbox-3 0 10 0 20 10 30\nclose-segment\n");
  ASSERT_EQ(run("sheet two.draw --up z -o s.svg --scale 1:1"), 0) << err_;
  const double right = 20.0 / std::sqrt(2.0), up = 20.0 / std::sqrt(6.0);
  int edges = 0;
  for (const Stroke& stroke : strokes_of(path_of("s.svg", "VISIBLE"))) {
    edges += std::abs(stroke[2] - stroke[0] - right) < 2e-5 &&
             std::abs(stroke[1] - stroke[3] - up) < 2e-5;
  }
  EXPECT_EQ(edges, 5);
}

TEST_F(SheetCommandTest, ALongTitleKeepsWithinItsCell) {
  const auto lines_of_title = [&](const std::string& arguments) {
    EXPECT_EQ(run("sheet box.obj -o s.svg --paper a4-portrait " + arguments), 0) << err_;
    std::vector<Text> lines;
    bool in_title = false;
    for (const Text& text : texts("s.svg")) {
      if (text.characters == "SCALE") in_title = false;
      if (in_title) lines.push_back(text);
      if (text.characters == "TITLE") in_title = true;
    }
    constexpr double kScales = 200.0 - 150.0 + 0.55 * 150.0, kBottom = 297.0 - 10.0;
    for (const Text& line : lines) {
      EXPECT_LT(line.left() + line.width(), kScales) << line.characters;
      EXPECT_LT(line.y, kBottom) << line.characters;
      EXPECT_GE(line.size * 0.72, 1.79) << line.characters;
    }
    return lines;
  };
  EXPECT_EQ(lines_of_title("--title Bracket").size(), 1U);
  EXPECT_NEAR(lines_of_title("--title 'Bracket, welded, of three plates'").front().size * 0.72, 3.5,
              1e-3);
  const auto lines = lines_of_title(
      "--title 'Bracket, welded, with a very long name that will surely not fit in the title block "
      "of a sheet'");
  ASSERT_GT(lines.size(), 1U);
  EXPECT_TRUE(lines.back().characters.ends_with("sheet"));
  EXPECT_EQ(err_, "");
  const auto of_one_word = lines_of_title("--title " + std::string(90, 'x'));
  EXPECT_GT(of_one_word.size(), 1U);
  for (const Text& line : of_one_word) {
    constexpr double kWidthOfX = 0.592;  // in DejaVu Sans
    EXPECT_LT(line.left() + line.width() * kWidthOfX / 0.45, 132.5) << line.characters;
  }
  EXPECT_EQ(err_, "");
  const auto shortened = lines_of_title("--title '" + std::string(500, 'x') + "'");
  EXPECT_TRUE(shortened.back().characters.ends_with("\xE2\x80\xA6"));
  EXPECT_NE(err_.find("s.svg: too long for the title block, shortened: TITLE xxx"),
            std::string::npos)
      << err_;
  EXPECT_NE(read(folder_ / "s.svg").find("<title>" + std::string(500, 'x')), std::string::npos);
}

TEST_F(SheetCommandTest, ALongDateIsShortened) {
  ASSERT_EQ(run("sheet box.obj -o s.svg --date 'the first of May of the year 2026, a Friday'"), 0);
  EXPECT_NE(err_.find("shortened: DATE the first of"), std::string::npos) << err_;
  ASSERT_EQ(run("sheet box.obj -o s.svg --date '1 May 2026, Friday'"), 0);
  EXPECT_EQ(err_, "");
}

TEST_F(SheetCommandTest, APartOfNoThicknessIsDrawn) {
  write("flat.draw", kTriangle);
  write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");  // and of no width
  for (const char* part : {"flat.draw", "line.obj"}) {
    ASSERT_EQ(run(std::string("sheet -o flat.svg ") + part), 0) << err_;
    EXPECT_FALSE(numbers("flat.svg", "VISIBLE").empty());
    EXPECT_EQ(run(std::string("sheet -o cut.svg --section side=0.5 ") + part), 0) << err_;
    EXPECT_TRUE(numbers("cut.svg", "HATCH").empty());
    expect_error(std::string("sheet -o no.svg --section front=0 ") + part,
                 "--section front=0: the part is flat there, at 0: expected no section");
  }
}

/// A box with a bore, and a pin that fills it with the same facets.
TEST_F(SheetCommandTest, TouchingSolidsHaveNoLinesWithinTheFaceThatTheyShare) {
  const std::string box = "box-3 -20 20 -20 20 0 20\n";
  const std::string pin = "open-segment 2\ncylinder-3 0 0 0 8 20 48\nclose-segment\n";
  const std::string bored = "open-segment 1\nbegin-solid difference\n" + box +
                            "cylinder-3 0 0 -1 8 22 48\nend-solid\nclose-segment\n";
  write("pin.draw", bored + pin);
  for (const char* section : {"", " --section side=0"}) {
    const std::string options = std::string(" --up z -o s.svg --scale 1:1") + section;
    if (!can_run("sheet pin.draw" + options, kNeedsCgal)) GTEST_SKIP() << err_;
    EXPECT_EQ(err_, "");
    int facets = 0;  // of the front view's bore, and of the side view's
    for (const Stroke& stroke : strokes_of(path_of("s.svg", "HIDDEN"))) {
      facets +=
          std::abs(stroke[2] - stroke[0]) < 1e-9 && std::abs(stroke[3] - stroke[1] - 20.0) < 1e-9;
    }
    EXPECT_EQ(facets, *section == '\0' ? 4 : 2) << section;
  }
}

TEST_F(SheetCommandTest, WhatProgramsDoNotDrawIsOnNoSheet) {
  const std::string box = "open-segment 1\nbox-3 0 40 0 20 0 10\nclose-segment\n";
  const std::string other = "open-segment 2\nbox-3 0 20 0 20 10 30\nclose-segment\n";
  const auto sheet = [&](const std::string& program) {
    write("a.draw", program);
    EXPECT_EQ(run("sheet a.draw -o s.svg --section front=5"), 0) << err_;
    EXPECT_EQ(err_, "");
    return read(folder_ / "s.svg");
  };
  const std::string alone = sheet(box);
  EXPECT_TRUE(sheet(box + other + "set-visibility 2 off\n") == alone);
  EXPECT_TRUE(sheet(box + "set-fill-style hollow\nset-line-style none\n" + other) == alone);
  EXPECT_FALSE(sheet(box + other) == alone);
}

TEST_F(SheetCommandTest, OutlinesOfAHollowPolygonHideNothing) {
  const std::string box = "open-segment 1\nbox-3 0 40 0 20 0 10\nclose-segment\n";
  const std::string plate =
      "open-segment 2\npolygon-abs-3 5 5 20  35 5 20  35 15 20  5 15 20\nclose-segment\n";
  const auto hidden = [&](const std::string& program) {
    write("a.draw", program);
    EXPECT_EQ(run("sheet a.draw -o s.svg --scale 1:1 --hidden-lines all"), 0) << err_;
    return strokes_of(path_of("s.svg", "HIDDEN")).size();
  };
  EXPECT_EQ(hidden(box + "set-fill-style hollow\n" + plate), hidden(box));
  EXPECT_GT(hidden(box + plate), hidden(box));
}

TEST_F(SheetCommandTest, WhatAProgramSaysBeforeAMeshActsOnIt) {
  write("wide.draw", "scale-3 3 1 1\n");
  write("wide.obj",
        "v 0 0 0\nv 180 0 0\nv 180 40 0\nv 0 40 0\nv 0 0 30\nv 180 0 30\nv 180 40 30\nv 0 40 30\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  write("off.draw", "set-visibility 2 off\n");
  const auto sheet = [&](const std::string& parts) {
    EXPECT_EQ(run("sheet " + parts + " --title a -o s.svg"), 0) << err_;
    EXPECT_EQ(err_, "");
    return read(folder_ / "s.svg");
  };
  const std::string wide = sheet("wide.obj");
  EXPECT_TRUE(sheet("wide.draw box.obj") == wide);
  EXPECT_TRUE(sheet("wide.obj box.obj off.draw") == wide);  // segments are named as in a picture
}

/// None where a bridge goes to a hole, and none where a face that is not flat, or one of a solid,
/// is divided.
TEST_F(SheetCommandTest, AllSidesAreThoseThatAPictureHas) {
  write("bridged.obj", plate_with_boss(true));
  ASSERT_EQ(run("sheet bridged.obj --up z -o s.svg --lines outline,boundary,crease"), 0) << err_;
  const std::string creases = read(folder_ / "s.svg");
  ASSERT_EQ(run("sheet bridged.obj --up z -o s.svg --lines all"), 0) << err_;
  EXPECT_TRUE(read(folder_ / "s.svg") != creases);  // a side there and back is one of the file's
  write("bored.draw",
        "open-segment 1\nbegin-solid difference\nbox-3 0 40 0 30 0 20\nbox-3 10 30 10 20 -1 21\n"
        "end-solid\nclose-segment\n");
  for (const char* section : {"", " --section front=-15", " --section side=20"}) {
    const std::string options = std::string(" --up z -o s.svg") + section;
    if (run("sheet bored.draw --lines outline,boundary,crease" + options) == 2) break;
    const std::string whole = read(folder_ / "s.svg");
    ASSERT_EQ(run("sheet bored.draw --lines all" + options), 0) << err_;
    EXPECT_TRUE(read(folder_ / "s.svg") == whole) << section;
  }
  write("bent.obj", "v 0 0 0\nv 40 0 0\nv 40 40 9\nv 0 40 0\nf 1 2 3 4\n");
  ASSERT_EQ(run("sheet bent.obj -o s.svg --lines all"), 0) << err_;
  const std::string bent = read(folder_ / "s.svg");
  ASSERT_EQ(run("sheet bent.obj -o s.svg --lines boundary"), 0) << err_;
  EXPECT_TRUE(read(folder_ / "s.svg") == bent);
}

TEST_F(SheetCommandTest, LinesAreWhereMaterialsDiffer) {
  write("two.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  write("two.obj",
        "mtllib two.mtl\nv 0 0 0\nv 10 0 0\nv 20 0 0\nv 20 10 9\nv 10 10 9\nv 0 10 9\n"
        "usemtl red\nf 1 2 5 6\nusemtl blue\nf 2 3 4 5\n");
  ASSERT_EQ(run("sheet two.obj -o s.svg --scale 1:1 --lines material"), 0) << err_;
  EXPECT_EQ(strokes_of(path_of("s.svg", "VISIBLE")).size(), 4U);  // one a view
  ASSERT_EQ(run("sheet two.obj -o s.svg --scale 1:1 --lines material --section top=5"), 0) << err_;
  EXPECT_EQ(strokes_of(path_of("s.svg", "VISIBLE")).size(), 4U);
}

TEST_F(SheetCommandTest, ATitleIsWellFormedInXml) {
  ASSERT_EQ(run("sheet box.obj -o s.svg --title 'a]]>b <&'"), 0) << err_;
  EXPECT_NE(read(folder_ / "s.svg").find("<title>a]]&gt;b &lt;&amp;</title>"), std::string::npos);
}

/// In DXF `%%c` is a diameter sign and `\U+0041` an A.
TEST_F(SheetCommandTest, ATitleInDxfIsWhatItSays) {
  if (!can_run("sheet box.obj -o s.dxf --title '50% 9%%c \\U+0041 \\x \xF0\x9F\x98\x80 \xC3\xA9'",
               kHasNoDxflib)) {
    GTEST_SKIP() << err_;
  }
  EXPECT_NE(
      read(folder_ / "s.dxf").find("50% 9%%%%%%c \\U+005CU+0041 \\x \\U+D83D\\U+DE00 \\U+00E9"),
      std::string::npos);
}

TEST_F(SheetCommandTest, WhatIsLeftOutIsToldWithTheNameOnce) {
  write("glass.mtl", "newmtl glass\nd 0.5\n");
  write("glass.obj", "mtllib glass.mtl\nusemtl glass\nv 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n");
  ASSERT_EQ(run("sheet glass.obj -o s.svg"), 0) << err_;
  EXPECT_TRUE(err_.starts_with("glass.obj: left out: ")) << err_;
}

TEST_F(SheetCommandTest, ALimitSuggestsNothingThatASheetHasNot) {
  write("two.draw",
        "open-segment 1\nbox-3 0 40 0 20 0 20\nbox-3 10 30 -10 30 5 15\nclose-segment\n");
  expect_error("sheet two.draw -o s.svg --limit-pieces 3",
               "3 pieces are not enough: expected a higher limit of pieces");
  EXPECT_EQ(err_.find("pixels"), std::string::npos) << err_;
}

TEST_F(SheetCommandTest, WritesPdfAndDxf) {
  ASSERT_EQ(run("sheet box.obj -o box.pdf"), 0) << err_;
  EXPECT_TRUE(read(folder_ / "box.pdf").starts_with("%PDF"));
  if (!can_run("sheet box.obj -o box.dxf --section front=10", kHasNoDxflib)) {
    EXPECT_NE(err_.find("libdxflib-dev"), std::string::npos) << err_;
    GTEST_SKIP() << err_;
  }
  const std::string dxf = read(folder_ / "box.dxf");
  for (const char* word : {"VISIBLE", "HIDDEN", "HATCH", "FRAME", "DASHEDTINY", "$INSUNITS"}) {
    EXPECT_NE(dxf.find(word), std::string::npos) << word;
  }
}

/// Programs that read DXF begin dashes anew at each side of a polyline: a curve's hidden ones are
/// its dashes themselves.
TEST_F(SheetCommandTest, HiddenCurvesAreDashedInDxf) {
  write("ring.draw",
        "open-segment 1\nturn-3 90  9 -10  20 -10  20 10  9 10  9 4  15 4  15 -4  9 -4\n"
        "close-segment\n");
  if (!can_run("sheet ring.draw -o ring.dxf", kHasNoDxflib)) GTEST_SKIP() << err_;
  std::istringstream dxf(read(folder_ / "ring.dxf"));
  std::size_t dashes = 0, curves = 0;
  std::string entity, layer;
  for (std::string code, value; std::getline(dxf, code) && std::getline(dxf, value);) {
    const int number = std::stoi(code);
    if (!value.empty() && value.back() == '\r') value.pop_back();
    if (number == 0) entity = value;
    if (number == 8) layer = value;
    if (number != 6 || layer != "HIDDEN") continue;
    dashes += value == "CONTINUOUS";
    curves += entity == "POLYLINE" && value == "BYLAYER";
  }
  EXPECT_GT(dashes, 40U);
  EXPECT_EQ(curves, 0U);
}

TEST_F(SheetCommandTest, AProgramSaysWhichAxisIsUp) {
  const std::string box = "open-segment 1\nbox-3 0 10 0 20 0 40\nclose-segment\n";
  write("y.draw", box);
  write("z.draw", "set-view-plane-normal 0 1 0\nset-parallel 0 1 0\nset-view-up 0 0 2\n" + box);
  const auto sheet = [&](const std::string& arguments) {
    EXPECT_EQ(run("sheet " + arguments + " --title box -o s.svg"), 0) << err_;
    return read(folder_ / "s.svg");
  };
  EXPECT_TRUE(sheet("z.draw") == sheet("y.draw --up z"));
  EXPECT_TRUE(sheet("z.draw") != sheet("y.draw"));
  EXPECT_TRUE(sheet("z.draw --up y") == sheet("y.draw"));
}

TEST_F(SheetCommandTest, ATitleFromANameThatIsNoTextIsDrawnAsOne) {
  fs::copy_file(folder_ / "box.obj", folder_ / "b\xff\x01x.obj");
  ASSERT_EQ(run("sheet 'b\xff\x01x.obj' -o s.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "s.svg").find("<title>b??x</title>"), std::string::npos);
}

TEST_F(SheetCommandTest, EveryOptionHasItsMessage) {
  expect_error("sheet box.obj -o box.png", "box.png: expected a sheet that ends in .svg, .pdf or");
  expect_error("sheet box.obj -o s.svg --paper a9", "unknown paper 'a9'");
  expect_error("sheet box.obj -o s.svg --margin 200", "margins of 200 mm");
  expect_error("sheet box.obj -o s.svg --scale 1", "--scale 1: expected PAPER:PART");
  expect_error("sheet box.obj -o s.svg --scale 1:0", "--scale 1:0: expected PAPER:PART");
  expect_error("sheet box.obj -o s.svg --scale 50:1", "--scale 50:1: the views do not fit");
  expect_error("sheet box.obj -o s.svg --projection second", "expected third or first");
  expect_error("sheet box.obj -o s.svg --unit foot", "--unit foot: expected mm, cm, m or in");
  expect_error("sheet box.obj -o s.svg --section back=1", "--section back=1: expected front=");
  expect_error("sheet box.obj -o s.svg --section front=nan", "--section front=nan: expected");
  expect_error("sheet box.obj -o s.svg --section top=1 --section top=2", "already has a section");
  expect_error("sheet box.obj -o s.svg --hatch 0", "--hatch 0: expected");
  expect_error("sheet box.obj -o s.svg --hatch fine", "--hatch: fine: expected a number");
  expect_error("sheet box.obj -o s.svg --margin -1", "margins of -1 mm");
  expect_error("sheet box.obj -o s.svg --paper 30x30", "no room for four views");
  expect_error("sheet box.obj -o s.svg --threads 0", "--threads");
  expect_error("sheet box.obj -o s.svg --title", "--title");
  expect_error("sheet box.obj -o s.svg --date", "--date");
  expect_error("sheet box.obj -o s.svg --title 'a\x01'", "--title: character U+0001 in a text");
  expect_error("sheet box.obj -o s.svg --date '\xff'", "--date: byte 0xff in a text");
  expect_error("sheet box.obj -o no/s.svg", "no/s.svg: cannot be written");
  expect_error("sheet box.obj -o s.svg --lines edge", "--lines: expected ");
  expect_error("sheet box.obj -o s.svg --lines outlines", "did you mean 'outline'?");
  expect_error("sheet box.obj -o s.svg --up w", "--up w: expected x, y, z, -x, -y or -z");
  expect_error("sheet box.obj -o s.svg --up auto", "--up auto: expected x, y, z, -x, -y or -z");
  expect_error("sheet none.obj -o s.svg", "none.obj: no such file");
  write("empty.draw", "open-segment 1\nclose-segment\n");
  expect_error("sheet empty.draw -o s.svg", "empty.draw: no polygons");
}

}  // namespace
