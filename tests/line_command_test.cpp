// Line drawings by the command: hidden lines dashed, and lines joined into chains.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "interp/opengl/osmesa.h"
#include "tests/command_fixture.h"

namespace {

class LineCommand : public Command {
 protected:
  /// A closed box as a mesh, its faces turned outward.
  static constexpr const char* kBox =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

  std::size_t count(const std::string& begin) const {
    std::size_t n = out_.starts_with(begin) ? 1 : 0;
    for (std::size_t at = out_.find("\n" + begin); at != std::string::npos;
         at = out_.find("\n" + begin, at + 1)) {
      ++n;
    }
    return n;
  }
};

TEST_F(LineCommand, HiddenLinesOfABareMeshAreDashedAndComeFirst) {
  write("box.obj", kBox);
  ASSERT_EQ(run("dump box.obj --hidden franklin"), 0) << err_;
  EXPECT_EQ(count("line "), 9u);
  EXPECT_EQ(count("line-style dashed "), 0u);
  ASSERT_EQ(run("dump box.obj --hidden franklin --hidden-lines none"), 0) << err_;
  EXPECT_EQ(count("line "), 9u);
  for (const char* method : {"franklin", "roberts"}) {
    ASSERT_EQ(run(std::string("dump box.obj --hidden-lines dashed --hidden ") + method), 0) << err_;
    EXPECT_GE(count("line "), 12u);  // and parts of hidden ones that rounding shows
    EXPECT_EQ(count("line-style dashed 0 0 0 0.5 6 4"), 1u) << out_;
    const std::size_t dashed = out_.find("line-style dashed"),
                      solid = out_.find("line-style solid");
    ASSERT_LT(dashed, solid);
    out_ = out_.substr(dashed, solid - dashed);
    EXPECT_EQ(count("line "), 3u);
  }
  ASSERT_EQ(run("draw box.obj -o box.svg --hidden franklin --hidden-lines dashed"), 0) << err_;
  EXPECT_NE(read(folder_ / "box.svg").find("stroke-width:0.5;stroke-dasharray:6 4"),
            std::string::npos);
}

/// Behind a plate, beyond which its ends are visible; a shorter line on the plate covers the rest
/// except for two ends.
TEST_F(LineCommand, HiddenLinesThatAreCoveredAreLeftOut) {
  write("plate.draw",
        "open-segment 1\n"
        "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0.5 0.5 0  -0.5 0.5 0\n"
        "move-abs-3 -0.9 0 -1\nline-abs-3 0.9 0 -1\n"
        "move-abs-3 0.4 0 0\nline-abs-3 -0.4 0 0\nclose-segment\n");
  ASSERT_EQ(run("dump plate.draw --hidden franklin --hidden-lines dashed"), 0) << err_;
  EXPECT_EQ(count("line "), 9u) << out_;
  out_ = out_.substr(0, out_.find("line-style solid"));
  EXPECT_EQ(count("line "), 2u);
}

/// A box within a box, seen along an axis and off it by a rounding: two of its hidden sides are
/// behind two others, whose gaps their dashes would fill.
TEST_F(LineCommand, HiddenLinesThatRoundingPartsAreDrawnOnce) {
  const auto program = [](const std::string& off) {
    return "set-view-plane-normal " + off + " -" + off + " -1\nset-parallel -" + off + " " + off +
           " 1\nset-window -1 21 -1 13\nset-view-depth -60 60\nset-hidden-method franklin\n"
           "set-hidden-line-removal on\nset-back-face-removal off\nset-hidden-lines dashed\n"
           "set-lines outline crease\nset-line-style solid 0 0 0 1\nopen-segment 1\n"
           "box-3 0 20 0 12 0 10\nbox-3 5.01 15.03 4.01 8.03 -1 5\nclose-segment\n";
  };
  write("along.draw", program("0"));
  write("off.draw", program("1.7e-16"));
  constexpr std::size_t kWidth = 440, kHeight = 280;
  // Without the outer box, whose sides are between pixels.
  const auto dark_inside = [&](const std::string& ppm) {
    const std::size_t first = ppm.size() - 3 * kWidth * kHeight;
    std::size_t dark = 0;
    for (std::size_t y = 40; y < 240; ++y) {
      for (std::size_t x = 40; x < 400; ++x) {
        dark += static_cast<unsigned char>(ppm[first + 3 * (y * kWidth + x)]) < 128 ? 1 : 0;
      }
    }
    return static_cast<double>(dark);
  };
  struct Drawn {
    std::size_t dashed;
    double dark, strokes;
  };
  const auto drawn = [&](const std::string& name, const std::string& method) {
    const std::string options = name + ".draw --size 440x280" + method;
    Drawn all{};
    EXPECT_EQ(run("dump " + name + ".draw" + method), 0) << err_;
    std::istringstream dashed(out_.substr(out_.find("line-style dashed")));
    double x = 0.0, y = 0.0;
    for (std::string line; std::getline(dashed, line) && !line.starts_with("line-style solid");) {
      double to_x = 0.0, to_y = 0.0;
      const bool is_line = line.starts_with("line ");
      if (!is_line && !line.starts_with("move ")) continue;
      std::istringstream(line.substr(5)) >> to_x >> to_y;
      if (is_line && std::hypot(to_x - x, to_y - y) > 1e-9) ++all.dashed;
      x = to_x;
      y = to_y;
    }
    EXPECT_EQ(run("draw " + options + " --samples 1 -o a.ppm"), 0) << err_;
    all.dark = dark_inside(read(folder_ / "a.ppm"));
    EXPECT_EQ(run("draw " + options + " --pens -o a.svg"), 0) << err_;
    all.strokes = static_cast<double>(std::ranges::count(read(folder_ / "a.svg"), 'M'));
    return all;
  };
  for (const std::string method : {"", " --hidden roberts", " --hidden appel"}) {
    const Drawn along = drawn("along", method), off = drawn("off", method);
    EXPECT_EQ(along.dashed, 4U) << method;
    EXPECT_EQ(off.dashed, 4U) << method;
    EXPECT_GT(along.dark, 300.0);
    EXPECT_NEAR(off.dark, along.dark, 8.0) << method;
    EXPECT_NEAR(off.strokes, along.strokes, 2.0) << method;
  }
}

TEST_F(LineCommand, AProgramSetsHiddenLinesAndTheCommandOtherwise) {
  const std::string square = "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0.5 0.5 0  -0.5 0.5 0\n";
  const std::string program =
      "set-hidden-method franklin\nset-hidden-line-removal on\nset-hidden-lines dashed\n"
      "open-segment 1\nset-line-style solid 1 0 0 4\n" +
      square + "move-abs-3 -0.9 0 -1\nline-abs-3 0.9 0 -1\nclose-segment\n";
  write("a.draw", program);
  ASSERT_EQ(run("dump a.draw"), 0) << err_;
  EXPECT_EQ(count("line-style dashed 1 0 0 2 12 8"), 1u) << out_;
  EXPECT_EQ(count("line "), 7u);
  ASSERT_EQ(run("dump a.draw --hidden-lines none"), 0) << err_;
  EXPECT_EQ(count("line-style dashed"), 0u);
  EXPECT_EQ(count("line "), 6u);
  // Over fills that were put in order.
  ASSERT_EQ(run("dump a.draw --hidden bsp"), 0) << err_;
  EXPECT_EQ(count("polygon "), 1u);
  EXPECT_GT(out_.find("line-style dashed"), out_.find("polygon "));
  ASSERT_EQ(run("draw a.draw -o a.svg --hidden depth-sort --stats"), 0) << err_;
}

TEST_F(LineCommand, UnknownHiddenLinesAreRefused) {
  write("a.draw", "set-hidden-lines dotted\n");
  expect_error("dump a.draw", "a.draw:1:18: hidden lines are none or dashed, not 'dotted'");
  write("b.draw", "set-hidden-lines\n");
  expect_error("dump b.draw",
               "b.draw:1:17: set-hidden-lines: 0 arguments, expected 1: none|dashed");
  write("box.obj", kBox);
  for (const char* command :
       {"dump box.obj", "draw box.obj -o x.png", "check box.obj --golden ."}) {
    expect_error(std::string(command) + " --hidden-lines dahsed",
                 "hidden lines are none or dashed, not 'dahsed'");
  }
}

/// Its first view is the scene as it was drawn; so the lines over its fills are those of the scene
/// drawn alone, with any method of surfaces and with hidden lines requested by option or program.
TEST_F(LineCommand, ATurntableHasTheLinesOfASceneDrawnAlone) {
  const std::string plates =
      "set-lines all intersection\nset-back-face-removal off\nopen-segment 1\n"
      "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0.5 0.5 0  -0.5 0.5 0\n"
      "polygon-abs-3 -0.4 -0.3 -1  0.4 -0.2 -1  0.4 0.3 1  -0.4 0.3 1\n"
      "close-segment\nopen-segment 2\nmove-abs-3 -0.9 0.1 -1\nline-abs-3 0.9 0.3 -1\n"
      "polygon-abs-3 -0.6 -0.8 -1  0.6 -0.7 0.7  0.1 -0.2 0.5\nclose-segment\n";
  write("plain.draw", plates);
  write("dashed.draw", "set-hidden-lines dashed\n" + plates);
  for (const std::string by : {"bsp", "bsp --scope segment", "z-buffer", "scan-line",
                               "world-ray-cast", "franklin", "roberts --scope segment"}) {
    const std::string with = " --size 90x70 --hidden " + by;
    const auto drawn = [&](const std::string& arguments) {
      EXPECT_EQ(run("draw " + arguments + with), 0) << err_;
      const std::string file = arguments.substr(arguments.find("-o ") + 3);
      return read(folder_ / (file.find(" ") == std::string::npos ? file : "t-000.png"));
    };
    const std::string none = drawn("plain.draw -o none.png");
    const std::string dashed = drawn("dashed.draw -o dashed.png");
    EXPECT_NE(none, dashed) << by;
    EXPECT_EQ(drawn("plain.draw -o t.png --turntable 1"), none) << by;
    EXPECT_EQ(drawn("dashed.draw -o t.png --turntable 1"), dashed) << by;
    EXPECT_EQ(drawn("plain.draw -o t.png --turntable 1 --hidden-lines dashed"), dashed) << by;
    EXPECT_EQ(drawn("dashed.draw -o t.png --turntable 1 --hidden-lines none"), none) << by;
    EXPECT_NE(drawn("plain.draw -o t.png --turntable 1 --lines all"), none) << by;
  }
}

/// In order of entry no method finds where lines are hidden: the option is refused, and a program
/// that sets hidden lines is drawn without them, with a warning.
TEST_F(LineCommand, HiddenLinesOfADrawingInOrderOfEntryAreRefused) {
  const std::string plate =
      "set-hidden-line-removal off\nopen-segment 1\n"
      "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0.5 0.5 0  -0.5 0.5 0\n";
  const std::string behind =
      plate + "move-abs-3 -0.9 0.1 -1\nline-abs-3 0.9 0.3 -1\nclose-segment\n";
  write("behind.draw", behind);
  write("before.draw", plate + "move-abs-3 -0.9 0.1 1\nline-abs-3 0.9 0.3 1\nclose-segment\n");
  write("dashed.draw", "set-hidden-lines dashed\n" + behind);
  const std::vector<std::pair<std::string, std::string>> in_order_of_entry{
      {"", "none"}, {" --hidden none", "none"}, {" --hidden back-face", "back-face"}};
  for (const auto& [with, method] : in_order_of_entry) {
    for (const std::string file : {"x.png", "x.svg"}) {
      expect_error("draw behind.draw --hidden-lines dashed -o " + file + with,
                   "hidden lines are not found by hidden-surface method '" + method +
                       "', which draws in order of entry: expected a method that hides, such as "
                       "map or franklin, or hidden lines none");
      EXPECT_FALSE(std::filesystem::exists(folder_ / file));
      // Where no line is hidden, none can be dashed.
      EXPECT_EQ(run("draw before.draw --hidden-lines dashed -o " + file + with), 0) << err_;
      EXPECT_EQ(err_, "");
      std::filesystem::remove(folder_ / file);
      EXPECT_EQ(run("draw dashed.draw -o " + file + with), 0) << err_;
      EXPECT_EQ(err_, file +
                          ": left out: set-hidden-lines dashed, as nothing finds hidden lines "
                          "in order of entry\n");
      EXPECT_EQ(run("draw dashed.draw --hidden-lines none -o " + file + with), 0) << err_;
      EXPECT_EQ(err_, "");
      std::filesystem::remove(folder_ / file);
    }
  }
  for (const std::string method : {"none", "back-face", "z-buffer", "world-ray-cast", "auto"}) {
    expect_error(
        "dump behind.draw --hidden-lines dashed --hidden " + method,
        "hidden lines need a method that sorts, which '" + method + "' does not: expected bsp, ");
    EXPECT_EQ(run("dump before.draw --hidden-lines dashed --hidden " + method), 0) << err_;
    EXPECT_EQ(run("dump dashed.draw --hidden " + method), 0) << err_;
  }
  for (const std::string method : {"z-buffer", "bsp", "map", "franklin", "auto"}) {
    EXPECT_EQ(run("draw dashed.draw -o y.png --hidden " + method), 0) << err_;
    EXPECT_EQ(err_, "");
  }
}

/// They are drawn by methods that find lines, or by an order of fills that has them: not by depths.
TEST_F(LineCommand, HiddenLinesThatNothingDrawsAreRefused) {
  const std::string plates =
      "set-back-face-removal off\nopen-segment 1\n"
      "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0.5 0.5 0  -0.5 0.5 0\n"
      "move-abs-3 -0.9 0.1 -1\nline-abs-3 0.9 0.3 -1\nclose-segment\n";
  write("plain.draw", plates);
  write("dashed.draw", "set-hidden-lines dashed\n" + plates);
  write("rule.draw",
        "set-hidden-method colour-rule\nset-hidden-line-removal on\n"
        "set-hidden-lines dashed\n" +
            plates);
  const auto refused = [&](const std::string& with, const std::string& by) {
    const bool is_sorted_for_views = with == " --hidden colour-rule";
    for (const char* views : {"", " --turntable 2"}) {
      if (*views != '\0' && is_sorted_for_views) continue;
      const std::string words = "hidden lines are not drawn by " + by + ": expected ";
      expect_error("draw plain.draw -o x.png --hidden-lines dashed" + with + views, words);
      expect_error("draw dashed.draw -o x.png" + with + views, words);
    }
  };
  for (const std::string rule : {"colour-rule", "colour-rule=z-buffer", "colour-rule=warnock"}) {
    refused(" --hidden " + rule, "hidden-line method '" + rule + "'");
  }
  expect_error("draw plain.draw -o x.svg --hidden-lines dashed --hidden colour-rule=none",
               "hidden-line method 'colour-rule=none': expected ");
  expect_error("dump rule.draw", "hidden-line method 'colour-rule': expected ");
  expect_error("draw rule.draw -o x.png", "hidden-line method 'colour-rule': expected ");
  for (const std::string method : {"z-buffer", "scan-line", "world-ray-cast"}) {
    refused(" --device osmesa --hidden " + method, "the osmesa device by '" + method + "'");
  }
  std::vector<std::string> drawing{"colour-rule=bsp", "colour-rule=depth-sort", "colour-rule=map",
                                   "none", "colour-rule --hidden-lines none"};
  if (displayfile::osmesa_available()) {
    drawing.insert(drawing.end(),
                   {"bsp --device osmesa", "map --device osmesa", "none --device osmesa",
                    "z-buffer --device osmesa --hidden-lines none"});
  }
  for (const std::string& by : drawing) {
    EXPECT_EQ(run("draw dashed.draw -o t.png --hidden " + by), 0) << err_;
  }
}

/// The box's outline and its inner corner: nine sides, drawn without lifting the pen but twice.
TEST_F(LineCommand, LinesAreJoinedIntoChains) {
  write("box.obj", kBox);
  ASSERT_EQ(run("dump box.obj --hidden franklin"), 0) << err_;
  EXPECT_LE(count("move "), 3u) << out_;
  ASSERT_EQ(run("draw box.obj -o box.svg --hidden franklin"), 0) << err_;
  const std::string svg = read(folder_ / "box.svg");
  EXPECT_LE(std::ranges::count(svg, 'M'), 3) << svg;
}

}  // namespace
