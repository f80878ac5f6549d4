// --line-order and --halo by the command, and their routines in programs.

#include <string>

#include "tests/command_fixture.h"

namespace {

class LineOrderCommand : public Command {
 protected:
  LineOrderCommand() {
    write("cross.draw", "set-hidden-line-removal on\n" + kCross);
    write("depth.draw", "set-line-order depth\n" + kCross);
  }
  /// Black is nearer, and entered first; red is behind it.
  static inline const std::string kCross =
      "set-window -1 1 -1 1\nopen-segment 1\nset-line-style solid 0 0 0 40\n"
      "set-pick-id 7\nmove-abs-3 0 -0.8 0.5\nline-abs-3 0 0.8 0.5\n"
      "set-line-style solid 1 0 0 40\nset-pick-id 8\nmove-abs-3 -0.8 0 -0.5\n"
      "line-abs-3 0.8 0 -0.5\nclose-segment\n";

  bool red_is_first(const std::string& svg) { return svg.find("#ff0000") < svg.find("#000000"); }
};

TEST_F(LineOrderCommand, PicturesAndPicksShowTheNearerLine) {
  for (const std::string method : {"", " --hidden franklin", " --hidden map"}) {
    ASSERT_EQ(run("draw cross.draw -o a.svg --line-order depth" + method), 0) << err_;
    EXPECT_TRUE(red_is_first(read(folder_ / "a.svg"))) << method;
    ASSERT_EQ(run("draw depth.draw -o b.svg" + method), 0) << err_;
    EXPECT_EQ(err_, "");
    EXPECT_EQ(read(folder_ / "b.svg"), read(folder_ / "a.svg"));
    ASSERT_EQ(run("draw depth.draw -o b.svg --line-order entry" + method), 0) << err_;
    EXPECT_FALSE(red_is_first(read(folder_ / "b.svg"))) << method;
  }
  for (const std::string method :
       {"", " --hidden franklin", " --hidden bsp", " --hidden warnock"}) {
    ASSERT_EQ(run("draw depth.draw -o a.ppm --pick 256,256,2" + method), 0) << err_;
    EXPECT_NE(out_.find("7"), std::string::npos) << out_;
    ASSERT_EQ(run("draw depth.draw -o a.ppm --pick 268,245,2" + method), 0) << err_;
    EXPECT_NE(out_.find("7"), std::string::npos) << out_;
    ASSERT_EQ(run("draw depth.draw -o a.ppm --pick 300,245,2" + method), 0) << err_;
    EXPECT_NE(out_.find("8"), std::string::npos) << out_;
  }
}

TEST_F(LineOrderCommand, AHaloHasUnits) {
  ASSERT_EQ(run("draw depth.draw -o a.svg --halo 5 --paper 100x100 --margin 0 --size 512x512"), 0)
      << err_;
  const std::string in_millimetres = read(folder_ / "a.svg");
  ASSERT_EQ(run("draw depth.draw -o b.svg --halo 5mm --paper 100x100 --margin 0 --size 512x512"), 0)
      << err_;
  EXPECT_EQ(read(folder_ / "b.svg"), in_millimetres);
  ASSERT_EQ(run("draw depth.draw -o b.svg --halo 25.6px --paper 100x100 --margin 0 --size 512x512"),
            0)
      << err_;
  EXPECT_EQ(read(folder_ / "b.svg"), in_millimetres);
  ASSERT_EQ(run("draw depth.draw -o b.svg --halo 5 --line-order depth"), 0) << err_;
  EXPECT_NE(read(folder_ / "b.svg"), in_millimetres);
  write("halo.draw", "set-line-halo 5\n" + read(folder_ / "depth.draw"));
  ASSERT_EQ(run("draw halo.draw -o c.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "c.svg"), read(folder_ / "b.svg"));
  ASSERT_EQ(run("draw halo.draw -o d.svg --halo 0"), 0) << err_;
  ASSERT_EQ(run("draw depth.draw -o e.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "d.svg"), read(folder_ / "e.svg"));
  ASSERT_EQ(run("draw halo.draw --pens -o p.svg"), 0) << err_;
  EXPECT_EQ(err_, "");
}

TEST_F(LineOrderCommand, BadValuesAreRefused) {
  expect_error("draw cross.draw -o x.svg --line-order dpeth",
               "the order of lines is entry or depth, not 'dpeth'");
  expect_error("draw cross.draw -o x.svg --halo 2", "a line halo of 2 pixels in line order entry");
  expect_error("draw depth.draw -o x.svg --halo 2mm", "--halo 2mm: a length in mm needs");
  expect_error("draw depth.draw -o x.svg --halo -2", "--halo -2: expected lengths above 0");
  expect_error("draw depth.draw -o x.svg --halo wide", "--halo wide: expected a length");
  expect_error("draw cross.draw -o x.svg --line-order depth --hidden none",
               "line order depth: hidden-surface method 'none' draws in order of entry");
  expect_error("draw cross.draw -o x.svg --line-order depth --hidden bsp",
               "line order depth: in vectors hidden-surface method 'bsp' draws lines among fills");
  expect_error("draw cross.draw -o x.png --line-order depth --hidden colour-rule",
               "line order depth: hidden-line method 'colour-rule'");
  write("a.draw", "set-line-order deep\n");
  expect_error("dump a.draw", "a.draw:1:16: the order of lines is entry or depth, not 'deep'");
  write("a.draw", "set-line-halo -1\n");
  expect_error("dump a.draw", "a line halo of -1: expected 0 to 1000000 pixels");
  write("a.draw", "set-line-halo wide\n");
  expect_error("dump a.draw", "a.draw:1:15");
}

TEST_F(LineOrderCommand, WhatHasNoEffectIsWarnedOf) {
  ASSERT_EQ(run("draw depth.draw -o x.svg --hidden none"), 0) << err_;
  EXPECT_NE(err_.find("line order depth has no effect"), std::string::npos) << err_;
  write("halo.draw", "set-line-halo 5\n" + kCross);
  ASSERT_EQ(run("draw halo.draw -o x.svg"), 0) << err_;
  EXPECT_NE(err_.find("a line halo has no effect: expected line order depth"), std::string::npos);
}

TEST_F(LineOrderCommand, DumpsHaveTheOrder) {
  write("sorted.draw", "set-hidden-line-removal on\nset-hidden-method franklin\n" +
                           std::string("set-line-order depth\nset-line-halo 8\n") + kCross);
  ASSERT_EQ(run("dump sorted.draw --hidden franklin"), 0) << err_;
  EXPECT_LT(out_.find("solid 1 0 0 40"), out_.find("solid 0 0 0 40")) << out_;
}

}  // namespace
