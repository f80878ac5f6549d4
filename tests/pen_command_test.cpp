// --paper, --margin, --pens, --hatch, --order and --pen-layers by the command.

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "tests/command_fixture.h"

namespace {

class PenCommand : public Command {
 protected:
  PenCommand() {
    write("box.obj",
          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
          "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n");
    write("flat.draw",
          "set-window 0 1 0 1\nopen-segment 1\nset-fill-style solid 0 0 0\n"
          "polygon-abs-2 0 0  1 0  1 1  0 1\nclose-segment\n");
  }
};

/// Nine sides of a box are visible: five points where an odd number of them ends or more, one
/// layer.
TEST_F(PenCommand, DrawsTheLinesOfAMesh) {
  ASSERT_EQ(run("draw box.obj --pens -o a.svg"), 0) << err_;
  const std::string svg = read(folder_ / "a.svg");
  EXPECT_NE(svg.find("width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\""),
            std::string::npos);
  EXPECT_NE(svg.find("inkscape:groupmode=\"layer\" inkscape:label=\"1 #000000 0.353 mm\""),
            std::string::npos);
  EXPECT_EQ(svg.find("inkscape:label=\"2 "), std::string::npos);
  EXPECT_NE(svg.find("<path"), std::string::npos);
  ASSERT_EQ(run("draw box.obj --pens --hidden roberts -o b.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "b.svg"), svg);
  ASSERT_EQ(run("draw box.obj --pens --threads 3 --quiet --paper A4 --margin 10 -o b.svg"), 0);
  EXPECT_EQ(read(folder_ / "b.svg"), svg);
  ASSERT_EQ(run("draw box.obj --pens --turntable 2 -o t.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "t-000.svg").find("inkscape:label=\"1 "), std::string::npos);
}

/// Settings that a program does not make are as without it, whichever comes first.
TEST_F(PenCommand, AMeshBesideAProgramIsDrawnAsByItself) {
  write("nothing.draw", "# nothing\n");
  write("segment.draw", "open-segment 7\nclose-segment\n");
  write("other.draw", "open-segment 20\nclose-segment\n");
  write("light.draw", "set-light 0 0 1\n");
  for (const std::string options :
       {"--pens", "--hatch 2", "--pens --hidden roberts", "--pens --hidden-lines dashed",
        "--pens --lines crease", "--pens --turntable 1"}) {
    const bool turns = options.find("turntable") != std::string::npos;
    const auto draw = [&](const std::string& inputs) {
      EXPECT_EQ(run("draw " + inputs + " -o a.svg " + options), 0) << err_;
      EXPECT_EQ(err_, "") << inputs << " " << options;
      return read(folder_ / (turns ? "a-000.svg" : "a.svg"));
    };
    const std::string bare = draw("box.obj");
    EXPECT_NE(bare.find("<path"), std::string::npos) << options;
    if (options.find("--lines") == std::string::npos) {
      EXPECT_EQ(draw("box.obj --lines outline,boundary,crease"), bare) << options;
    }
    EXPECT_EQ(draw("nothing.draw box.obj"), bare) << options;
    EXPECT_EQ(draw("box.obj nothing.draw"), bare) << options;
    EXPECT_EQ(draw("segment.draw box.obj other.draw"), bare) << options;
    EXPECT_EQ(draw("box.obj"), bare) << options;
    if (options != "--hatch 2") {
      EXPECT_EQ(draw("light.draw box.obj"), bare) << options;
    }
  }
  // Each of many inputs is drawn by itself.
  ASSERT_EQ(run("draw box.obj -o alone.svg --pens"), 0) << err_;
  ASSERT_EQ(run("draw box.obj flat.draw -o '{name}.svg' --pens"), 0) << err_;
  EXPECT_EQ(read(folder_ / "box.svg"), read(folder_ / "alone.svg"));
}

TEST_F(PenCommand, WhatAProgramSetsHoldsForAMeshBesideIt) {
  write("roof.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0.05\nv 0 1 0.05\nv 1 2 0\nv 0 2 0\n"
        "f 1 2 3 4\nf 4 3 5 6\n");  // 7 sides; that in the middle hardly bends
  const auto draw = [&](const std::string& inputs, const std::string& options = "") {
    EXPECT_EQ(run("draw " + inputs + " -o a.svg --pens " + options), 0) << err_;
    return read(folder_ / "a.svg");
  };
  const std::string bare = draw("roof.obj");
  const std::string all = draw("roof.obj", "--lines all");
  EXPECT_NE(all, bare);
  write("all.draw", "set-lines all\n");
  EXPECT_EQ(draw("all.draw roof.obj"), all);
  EXPECT_EQ(draw("roof.obj all.draw"), bare);
  EXPECT_EQ(draw("all.draw roof.obj", "--lines outline,boundary,crease"), bare);
  write("red.draw", "set-line-style solid 1 0 0 2\n");
  const std::string red = draw("red.draw roof.obj");
  EXPECT_NE(red.find("#ff0000"), std::string::npos);
  EXPECT_EQ(std::ranges::count(red, 'M'), std::ranges::count(bare, 'M'));
  // A program's own sides are drawn as without a mesh.
  write("flat-pair.draw",
        "open-segment 5\npolygon-abs-3 0 3 0  1 3 0  1 4 0\npolygon-abs-3 0 3 0  1 4 0  0 4 0\n"
        "close-segment\n");
  const auto moves = [&](const std::string& inputs, const std::string& options) {
    const std::string svg = draw(inputs, options);
    return svg.find("<path") == std::string::npos ? 0 : std::ranges::count(svg, ' ');
  };
  for (const std::string inputs : {"flat-pair.draw roof.obj", "roof.obj flat-pair.draw"}) {
    EXPECT_GT(moves(inputs, ""), moves(inputs, "--lines outline,boundary,crease")) << inputs;
  }
}

/// Whatever the reason.
TEST_F(PenCommand, SaysThatNothingIsDrawn) {
  write("no-lines.draw", "set-line-style none\n");
  write("fill.draw",
        "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n"
        "set-fill-style solid 1 1 1\npolygon-abs-2 0 0  1 0  1 1  0 1\nclose-segment\n");
  write("dark.draw", "set-background 0 0 0\n" + read(folder_ / "fill.draw"));
  for (const std::string arguments :
       {"no-lines.draw box.obj --pens -o a.svg", "no-lines.draw box.obj --pens -o a.pdf",
        "no-lines.draw box.obj --pens --hidden map -o a.svg", "fill.draw --pens -o a.svg",
        "fill.draw --hatch 2 -o a.svg", "no-lines.draw box.obj --pens --turntable 3 -o a.svg"}) {
    ASSERT_EQ(run("draw " + arguments), 0) << err_;
    const std::string why = arguments.find("--hatch") == std::string::npos
                                ? "no line is visible, and fills are drawn with --hatch only"
                                : "no line is visible, and no fill that hatching shows";
    EXPECT_NE(err_.find("pens draw nothing: " + why + "\n"), std::string::npos) << arguments << "\n"
                                                                                << err_;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << arguments << "\n" << err_;
    ASSERT_EQ(run("draw --quiet " + arguments), 0) << err_;
    EXPECT_EQ(err_, "");
  }
  ASSERT_EQ(run("draw no-lines.draw --pens -o a.svg"), 0) << err_;
  EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
  EXPECT_NE(err_.find("nothing is seen"), std::string::npos) << err_;
  for (const std::string arguments :
       {"no-lines.draw box.obj --hatch 2 -o a.svg", "box.obj --pens -o a.svg",
        "fill.draw --hatch 2 --background black -o a.svg", "dark.draw --hatch 2 -o a.svg",
        "no-lines.draw box.obj -o a.svg"}) {
    ASSERT_EQ(run("draw " + arguments), 0) << err_;
    EXPECT_EQ(err_, "") << arguments;
  }
}

TEST_F(PenCommand, HatchesFills) {
  ASSERT_EQ(run("draw flat.draw --hatch 2,0 --paper 100x120 --margin 10 -o a.svg"), 0) << err_;
  std::string svg = read(folder_ / "a.svg");
  EXPECT_NE(svg.find("viewBox=\"0 0 100 120\""), std::string::npos);
  EXPECT_NE(svg.find("inkscape:label=\"2 #000000 0.3 mm\""), std::string::npos) << svg;
  ASSERT_EQ(run("draw flat.draw --hatch 2,30,cross,width=0.5,#ff0000 -o a.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "a.svg").find("#ff0000 0.5 mm"), std::string::npos);
}

/// The number of strokes of the hatching: subpaths of its layer's paths.
std::ptrdiff_t hatched_strokes(const std::string& svg) {
  const std::size_t layer = svg.find("#000000 0.3 mm");
  return layer == std::string::npos
             ? 0
             : std::count(svg.begin() + static_cast<std::ptrdiff_t>(layer), svg.end(), 'M');
}

/// Lines run on over the facets of curved surfaces, as with Gouraud shading, and an edge stays an
/// edge.
TEST_F(PenCommand, HatchesRoundPartsOnOneGrid) {
  const std::string view =
      "set-light -0.5 1 0.7 0.2\nset-perspective 3 6 4\nset-view-up 0 0 1\n"
      "set-view-plane-normal -3 -6 -4\nset-line-style none\nset-hidden-line-removal "
      "on\nopen-segment 1\n";
  for (const char* shape :
       {"cylinder-3 0 0 -0.6 0.5 1.2 32", "torus-3 0 0 0 0.6 0.3 32",
        "turn-3 32  0 -0.7  0.3 -0.7  0.5 -0.4  0.5 -0.1  0.25 0.3  0.2 0.5  0.35 0.7  0 0.7"}) {
    write("round.draw", view + shape + "\nclose-segment\n");
    const auto strokes = [&](const std::string& options) {
      EXPECT_EQ(run("draw round.draw -o a.svg --hatch 1 --paper A4" + options), 0) << err_;
      EXPECT_EQ(err_, "");
      return hatched_strokes(read(folder_ / "a.svg"));
    };
    const auto smooth = strokes(" --shading gouraud");
    EXPECT_GT(smooth, 50) << shape;
    EXPECT_LE(static_cast<double>(strokes("")), 1.2 * static_cast<double>(smooth)) << shape;
    EXPECT_GT(2 * strokes(" --shading flat"), 3 * smooth) << shape;
  }
  ASSERT_EQ(run("draw box.obj --hatch 2 -o a.svg"), 0) << err_;
  const std::string box = read(folder_ / "a.svg");
  ASSERT_EQ(run("draw box.obj --hatch 2 --shading flat -o a.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "a.svg"), box);
  ASSERT_EQ(run("draw box.obj --hatch 2 --shading gouraud -o a.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "a.svg"), box);
  ASSERT_EQ(run("draw box.obj --hatch 2 --crease 120 -o b.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "a.svg"), read(folder_ / "b.svg"));
}

TEST_F(PenCommand, PutsAnyVectorsOnPaper) {
  ASSERT_EQ(run("draw box.obj --paper a5-landscape -o a.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "a.svg").find("width=\"210mm\" height=\"148mm\""), std::string::npos);
  ASSERT_EQ(run("draw box.obj --paper letter --margin 0 -o a.pdf"), 0) << err_;
  EXPECT_NE(read(folder_ / "a.pdf").find("/MediaBox [ 0 0 612 792 ]"), std::string::npos);
}

TEST_F(PenCommand, TellsThatTextsAreLeftOut) {
  write("text.draw", "open-segment 1\nmove-abs-2 0 0\nline-abs-2 1 1\ntext \"A\"\nclose-segment\n");
  ASSERT_EQ(run("draw text.draw --pens -o a.svg"), 0) << err_;
  EXPECT_NE(err_.find("vectors leave out texts"), std::string::npos) << err_;
}

TEST_F(PenCommand, TellsWhatElseIsLeftOut) {
  write("shadow.draw",
        "set-light 1 0 1 0.2\nset-shadows on\nopen-segment 1\n"
        "polygon-abs-3 -0.8 -0.8 -0.5  0.8 -0.8 -0.5  0.8 0.8 -0.5\n"
        "polygon-abs-3 -0.3 -0.3 0.5  0.3 -0.3 0.5  0.3 0.3 0.5\nclose-segment\n");
  const auto told = [&](const std::string& options, const std::string& what) {
    EXPECT_EQ(run("draw shadow.draw -o a.svg " + options), 0) << err_;
    return err_.find(what) != std::string::npos;
  };
  EXPECT_TRUE(told("--hatch 3 --hidden none", "vectors leave out shadows"));
  EXPECT_TRUE(told("--hatch 3 --hidden back-face", "shadows"));
  EXPECT_FALSE(told("--hatch 3 --hidden map", "shadows"));
  EXPECT_FALSE(told("--pens", "shadows"));  // lines have none
  EXPECT_TRUE(told("--hatch 3 --samples 4", "--samples"));
  EXPECT_TRUE(told("--pens --samples 4", "--samples"));
  EXPECT_FALSE(told("--pens", "leave out"));
}

/// A renderer draws nothing by a width of 0.
TEST_F(PenCommand, ThePenOfAHairlineHasAWidth) {
  write("hair.draw",
        "set-line-style solid 1 0 0 0.001\nopen-segment 1\nmove-abs-2 0 0\nline-abs-2 1 1\n"
        "close-segment\n");
  ASSERT_EQ(run("draw hair.draw --pens -o a.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "a.svg").find("\"1 #ff0000 0.001 mm\""), std::string::npos);
  ASSERT_EQ(run("draw flat.draw --hatch 2,0,width=0.0001 -o a.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "a.svg").find("\"2 #000000 0.001 mm\""), std::string::npos);
}

/// In all vectors.
TEST_F(PenCommand, ADashedLineOfNoLengthIsADot) {
  for (const std::string style : {"solid 1 0 0 3", "dashed 1 0 0 3"}) {
    write("dot.draw", "set-line-style " + style +
                          "\nopen-segment 1\nmove-abs-2 0.5 0.5\nline-abs-2 0.5 0.5\n"
                          "close-segment\n");
    ASSERT_EQ(run("draw dot.draw --pens -o a.svg"), 0) << err_;
    EXPECT_NE(read(folder_ / "a.svg").find("<path"), std::string::npos) << style;
    ASSERT_EQ(run("draw dot.draw -o a.svg"), 0) << err_;
    EXPECT_NE(read(folder_ / "a.svg").find("stroke-linecap=\"square\""), std::string::npos);
    // To be read where the PDF is compressed.
    ASSERT_EQ(run("draw dot.draw --background none -o a.eps"), 0) << err_;
    EXPECT_NE(read(folder_ / "a.eps").find("1 0 0 rg"), std::string::npos) << style;
  }
}

TEST_F(PenCommand, MistakesAreTold) {
  expect_error("draw box.obj --paper A11 -o a.svg", "unknown paper 'A11'");
  expect_error("draw box.obj --paper A4 -o a.png", ".png files have no size on paper");
  expect_error("draw box.obj --pens -o a.ppm", ".ppm files are not for pens: expected one of");
  expect_error("draw box.obj --paper A4 --margin 200 -o a.svg", "margins of 200 mm");
  expect_error("draw box.obj --paper A4 --margin -1 -o a.pdf", "margins of -1 mm");
  expect_error("draw box.obj --margin 10 -o a.svg", "--margin 10: expected with --paper");
  expect_error("draw box.obj --pens --hidden bsp -o a.svg", "hides by painting over");
  expect_error("draw box.obj --pens --hidden z-buffer -o a.svg", "hides by painting over");
  expect_error("draw box.obj --pens --turntable 3 --hidden bsp -o a.svg", "hides by painting over");
  expect_error("draw flat.draw --hatch 1 --hidden franklin -o a.svg", "draws no fills");
  for (const std::string method : {"", " --hidden map", " --hidden none", " --hidden bsp"}) {
    expect_error("draw box.obj --hatch 1 --turntable 1 -o a.svg" + method,
                 "a turntable's views are not hatched: expected --pens without --hatch, or no "
                 "--turntable");
  }
  for (const char* const hatch :
       {"x", "1,", "1,45,", ",45", "1,45,60", "1,cross,45,7", "1,blue?"}) {
    expect_error(std::string("draw flat.draw --hatch '") + hatch + "' -o a.svg",
                 "expected SPACING[,ANGLE]");
  }
  expect_error("draw flat.draw --hatch 0.01 -o a.svg", "hatching 0.01 mm apart");
  expect_error("draw flat.draw --hatch 1,0,width=0 -o a.svg", "by a pen of 0 mm");
}

TEST_F(PenCommand, PensCutInnerContoursFirst) {
  write("plate.draw",
        "set-window 0 1 0 1\nset-line-style solid 1 0 0\nopen-segment 1\n"
        "move-abs-2 0.1 0.1\nline-abs-2 0.9 0.1\nline-abs-2 0.9 0.9\nline-abs-2 0.1 0.9\n"
        "line-abs-2 0.1 0.1\nset-line-style solid 0 0 1\nmove-abs-2 0.4 0.4\nline-abs-2 0.6 0.4\n"
        "line-abs-2 0.5 0.6\nline-abs-2 0.4 0.4\nset-line-style solid 1 0 0\nmove-abs-2 0.2 0.2\n"
        "line-abs-2 0.3 0.2\nline-abs-2 0.3 0.3\nline-abs-2 0.2 0.2\nclose-segment\n");
  const auto order_of = [&](const std::string& options) {
    EXPECT_EQ(run("draw plate.draw -o a.svg --pens " + options), 0) << err_;
    const std::string svg = read(folder_ / "a.svg");
    std::string order;
    for (const char* label : {"#ff0000", "#0000ff"}) {
      const auto at = svg.find(std::string("inkscape:label=\"1 ") + label);
      if (at != std::string::npos) order = label;
    }
    return order;
  };
  EXPECT_EQ(order_of(""), "#ff0000");
  EXPECT_EQ(order_of("--pen-layers blue"), "#0000ff");
  EXPECT_EQ(order_of("--pen-layers blue,red"), "#0000ff");
  EXPECT_EQ(order_of("--pen-layers red,#0000ff --order cut"), "#ff0000");
  EXPECT_EQ(err_, "");
  // The triangle in the plate, which has fewer corners, is drawn before it.
  const std::string svg = read(folder_ / "a.svg");
  const std::regex path("<path d=\"([^\"]*)\"");
  std::vector<std::string> paths;
  for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) {
    paths.push_back((*it)[1]);
  }
  ASSERT_EQ(paths.size(), 3u) << svg;
  EXPECT_LT(paths[0].size(), paths[1].size());
  ASSERT_EQ(run("draw plate.draw -o a.svg --pens --pen-layers green"), 0) << err_;
  EXPECT_NE(err_.find("layer #008000 has no effect: no pen of the picture has this colour"),
            std::string::npos)
      << err_;
  expect_error("draw plate.draw -o x.svg --order cut", "--order cut: expected with --pens or");
  expect_error("draw plate.draw -o x.svg --pen-layers red",
               "--pen-layers red: expected with --pens or");
  expect_error("draw plate.draw -o x.svg --pens --order deep",
               "--order: the order of pens is travel or cut, not 'deep'");
  expect_error("draw plate.draw -o x.svg --pens --pen-layers red,", "--pen-layers red,: ''");
  expect_error("draw plate.draw -o x.svg --pens --pen-layers red,rde",
               "--pen-layers red,rde: 'rde'");
  expect_error("draw plate.draw -o x.svg --pens --pen-layers red,#ff0000",
               "layers 1 and 2 of pens");
}

}  // namespace
