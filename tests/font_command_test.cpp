// --font and --text by the command.

#include <algorithm>
#include <string>

#include "tests/command_fixture.h"

namespace {

class FontCommand : public Command {
 protected:
  FontCommand() {
    write("i.draw", text_of("I", "left"));
    write("accent.draw", text_of("e\u00e9\u00fc", "left"));
  }

  /// Letters of half the picture's height, at (0.2, 0.25).
  static std::string text_of(const std::string& characters, const std::string& alignment) {
    return "set-window 0 1 0 1\nset-text-style 0.5 " + alignment +
           "\nopen-segment 1\nmove-abs-2 0.2 0.25\ntext \"" + characters + "\"\nclose-segment\n";
  }

  bool has_hershey_fonts() {
    return can_run("draw i.draw -o has.svg --font hershey", "hershey-fonts-data");
  }
  std::string drawn(const std::string& arguments, const std::string& file = "a.svg") {
    EXPECT_EQ(run("draw " + arguments + " -o " + file), 0) << err_;
    return read(folder_ / file);
  }
  static std::string::difference_type count(const std::string& text, const std::string& word) {
    std::string::difference_type n = 0;
    for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++n;
    return n;
  }
};

const std::string kPlot = " --pens --paper 100x100 --margin 0 --size 100x100";

/// The letter I of futural is a stroke 21 units high, in the middle of 8. Capitals are 0.72 of the
/// size, which is 50 mm here: a unit is 12/7 mm.
TEST_F(FontCommand, HersheyLettersAreStrokesOfPens) {
  if (!has_hershey_fonts()) GTEST_SKIP() << err_;
  EXPECT_NE(drawn("i.draw --font hershey" + kPlot).find("d=\"M26.857 39l0 36\""), std::string::npos)
      << read(folder_ / "a.svg");
  EXPECT_EQ(err_, "");
  EXPECT_EQ(drawn("i.draw --font hershey:futural" + kPlot, "b.svg"), read(folder_ / "a.svg"));
  write("right.draw", text_of("I", "right"));
  EXPECT_NE(drawn("right.draw --font hershey" + kPlot).find("d=\"M13.143 39l0 36\""),
            std::string::npos)
      << read(folder_ / "a.svg");
  write("centre.draw", text_of("II", "centre"));
  const std::string two = drawn("centre.draw --font hershey" + kPlot);
  EXPECT_NE(two.find("d=\"M13.143 39l0 36\""), std::string::npos) << two;
  EXPECT_NE(two.find("d=\"M26.857 75l0-36\""), std::string::npos) << two;
  // The pen is the line style's.
  write("red.draw", "set-line-style solid 1 0 0 3\n" + text_of("I", "left"));
  EXPECT_NE(drawn("red.draw --font hershey" + kPlot).find("#ff0000 3 mm"), std::string::npos);
  EXPECT_NE(drawn("i.draw --font hershey:gothiceng" + kPlot), read(folder_ / "b.svg"));
}

TEST_F(FontCommand, HersheyLettersAreLinesInVectorsAndPixels) {
  if (!has_hershey_fonts()) GTEST_SKIP() << err_;
  const std::string svg = drawn("i.draw --font hershey --size 100x100");
  EXPECT_EQ(svg.find("<text"), svg.npos);
  EXPECT_NE(svg.find("d=\"M26.857 39l0 36\""), svg.npos) << svg;
  EXPECT_NE(svg.find("stroke-linecap:round"), svg.npos);
  const std::string pdf = drawn("i.draw --font hershey", "a.pdf");
  EXPECT_EQ(pdf.find("/Font"), pdf.npos);
  EXPECT_NE(drawn("i.draw --font hershey --samples 1", "a.ppm"),
            drawn("i.draw --samples 1", "b.ppm"));
  // A line of 40 pixels is 40 pixels wide with each number of samples.
  write("wide.draw", "set-line-style solid 0 0 0 40\n" + text_of("I", "left"));
  for (const std::string samples : {"1", "4"}) {
    const std::string pixels =
        drawn("wide.draw --font hershey --size 100x100 --samples " + samples, "w.ppm");
    const std::string row = pixels.substr(pixels.size() - 3 * 100 * 43, 3 * 100);
    EXPECT_NEAR(static_cast<double>(count(row, std::string(3, '\0'))), 3.0 * 40.0 - 2.0, 6.0)
        << samples;
  }
}

TEST_F(FontCommand, HersheyFontsThatLackLettersWarnOnce) {
  if (!has_hershey_fonts()) GTEST_SKIP() << err_;
  write("more.draw",
        text_of("\u00e9", "left") + "open-segment 2\ntext \"\u00fc\u00e9\"\nclose-segment\n");
  for (const std::string& options : {kPlot, std::string(), std::string(" --hidden bsp")}) {
    drawn("more.draw --font hershey" + options);
    EXPECT_NE(err_.find("a.svg: the Hershey font futural lacks \u00e9 \u00fc: left out\n"),
              err_.npos)
        << options << err_;
    EXPECT_EQ(count(err_, "lacks"), 1) << err_;
  }
}

/// Axes write negative numbers with a sign that is not in ASCII.
TEST_F(FontCommand, HersheyFontsHaveSignsAndQuotationMarks) {
  if (!has_hershey_fonts()) GTEST_SKIP() << err_;
  write("typeset.draw", text_of("\u22122\u00d73\u20134 \u2019", "left"));
  write("plain.draw", text_of("-2x3-4 '", "left"));
  const std::string typeset = drawn("typeset.draw --font hershey" + kPlot);
  EXPECT_EQ(err_, "");
  EXPECT_EQ(typeset, drawn("plain.draw --font hershey" + kPlot, "b.svg"));
  EXPECT_NE(typeset, drawn("i.draw --font hershey" + kPlot, "b.svg"));
}

/// Signs of dimensions are no letters of these fonts; other letters of annotation are named.
TEST_F(FontCommand, HersheyFontsDrawDimensions) {
  if (!has_hershey_fonts()) GTEST_SKIP() << err_;
  const auto strokes_of = [&](const std::string& routine) {
    write("d.draw", "open-segment 1\n" + routine + "\nclose-segment\n");
    EXPECT_EQ(run("draw d.draw -o a.svg --pens --font hershey"), 0) << err_;
    return static_cast<int>(count(read(folder_ / "a.svg"), "M"));
  };
  const int number = strokes_of("leader-3 0.5 0.5 0 \"1\"");
  EXPECT_EQ(strokes_of("leader-3 0.5 0.5 0 \"\u00d81\""), number + 2) << err_;
  EXPECT_EQ(err_.find("lacks"), err_.npos) << err_;
  EXPECT_EQ(strokes_of("leader-3 0.5 0.5 0 \"1\u00b0\""), number + 1);
  EXPECT_EQ(strokes_of("leader-3 0.5 0.5 0 \"\u00b11\""), number + 3);
  EXPECT_EQ(err_.find("lacks"), err_.npos) << err_;
  strokes_of("leader-3 0.5 0.5 0 \"\u00e9\"");
  EXPECT_NE(err_.find("the Hershey font futural lacks \u00e9: left out"), err_.npos) << err_;
}

TEST_F(FontCommand, HersheyFontsOfOtherNamesAreRefused) {
  if (!has_hershey_fonts()) GTEST_SKIP() << err_;
  expect_error("draw i.draw -o a.svg --font hershey:futurall",
               "--font hershey:futurall: unknown Hershey font: did you mean");
  expect_error("draw i.draw -o a.svg --font hershey:../futural", "unknown Hershey font");
  expect_error("draw i.draw -o a.svg --font hershey --text outlines",
               "--font hershey is strokes, which have no outlines");
}

TEST_F(FontCommand, AFontOfTheSystemIsNamed) {
  const std::string svg = drawn("i.draw --font 'DejaVu Serif'");
  EXPECT_NE(svg.find("font-family:'DejaVu Serif',sans-serif;"), svg.npos) << svg;
  EXPECT_NE(drawn("i.draw --font serif").find("font-family:serif;"), svg.npos);
  EXPECT_EQ(err_, "");
  EXPECT_NE(drawn("i.draw").find("font-family:sans-serif;"), svg.npos);
  if (can_run("draw i.draw -o a.pdf --font 'No Such Font'", "Cairo")) {
    EXPECT_NE(err_.find("a.pdf: this system has no font No Such Font: "), err_.npos) << err_;
  }
}

TEST_F(FontCommand, WhatIsNoNameIsRefused) {
  for (const std::string font :
       {"'a\"b'", "\"it's\"", "'a;b'", "'<b>'", "' serif'", "a/b", "'a:b'"}) {
    expect_error("draw i.draw -o a.svg --font " + font,
                 "expected the name of a font of the system");
  }
  expect_error("draw i.draw -o a.svg --font ''", "--font");
  expect_error("draw i.draw -o a.svg --text lines", "--text lines: expected text or outlines");
  expect_error("draw i.draw -o a.svg --font serif --pens",
               "font serif for pens: expected hershey, or texts as outlines");
}

TEST_F(FontCommand, LettersAsOutlines) {
  if (!can_run("draw i.draw -o a.svg --text outlines --size 100x100", "Cairo")) GTEST_SKIP();
  const std::string svg = read(folder_ / "a.svg");
  EXPECT_EQ(svg.find("<text"), svg.npos);
  EXPECT_EQ(count(svg, "<path"), 1) << svg;
  // An o has an inner outline in the path of its letter.
  write("o.draw", text_of("ol", "left"));
  const std::string two = drawn("o.draw --text outlines");
  EXPECT_EQ(count(two, "<path"), 2) << two;
  EXPECT_EQ(count(two, "Z"), 3) << two;
  EXPECT_NE(drawn("o.draw --text outlines --font serif", "b.svg"), two);
  // Small letters far from the origin are there too.
  write("small.draw",
        "set-window 0 1 0 1\nset-text-style 0.02 right\nopen-segment 1\n"
        "move-abs-2 0.9 0.1\ntext \"ol\"\nclose-segment\n");
  EXPECT_EQ(count(drawn("small.draw --text outlines", "b.svg"), "<path"), 2);
  EXPECT_NE(drawn("o.draw --text text", "b.svg").find("<text"), two.npos);
  const std::string pdf = drawn("o.draw --text outlines", "a.pdf");
  EXPECT_EQ(pdf.find("/Font"), pdf.npos);
  const std::string plotted = drawn("o.draw --text outlines" + kPlot);
  EXPECT_EQ(err_, "");
  EXPECT_EQ(count(plotted, "<path"), 3) << plotted;
  EXPECT_EQ(count(plotted, "z\"/>"), 3) << plotted;
  drawn("o.draw --text outlines", "a.ppm");
  EXPECT_NE(err_.find("pixels leave out --text outlines"), err_.npos) << err_;
}

TEST_F(FontCommand, PensThatDrawNoTextsSayWhatWould) {
  drawn("i.draw" + kPlot);
  EXPECT_NE(err_.find("texts, which pens draw with --font hershey or --text outlines"), err_.npos)
      << err_;
}

TEST_F(FontCommand, HersheyLettersOfASheetAreLinesInEachFormat) {
  if (!has_hershey_fonts()) GTEST_SKIP() << err_;
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  ASSERT_EQ(run("sheet m.obj -o plain.svg"), 0) << err_;
  ASSERT_EQ(run("sheet m.obj -o s.svg --font hershey --title 'A title \u00e9'"), 0) << err_;
  EXPECT_NE(err_.find("s.svg: the Hershey font futural lacks \u00e9: left out"), err_.npos) << err_;
  const std::string svg = read(folder_ / "s.svg");
  EXPECT_EQ(svg.find("<text"), svg.npos);
  EXPECT_NE(svg.find("id=\"TEXT"), svg.npos);
  EXPECT_NE(read(folder_ / "plain.svg").find("<text"), svg.npos);
  ASSERT_EQ(run("sheet m.obj -o s.svg --font 'DejaVu Serif'"), 0) << err_;
  EXPECT_NE(read(folder_ / "s.svg").find("font-family=\"'DejaVu Serif',sans-serif\""), svg.npos);
  expect_error("sheet m.obj -o s.svg --font hershey:none", "unknown Hershey font");
  if (!can_run("sheet m.obj -o s.dxf --font hershey", "dxflib")) return;
  EXPECT_EQ(read(folder_ / "s.dxf").find("\nTEXT\n  5"), svg.npos);
  expect_error("sheet m.obj -o t.dxf --font serif",
               "--font serif: DXF has texts in the font of its");
}

}  // namespace
