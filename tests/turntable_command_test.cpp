// The command `displayfile draw --turntable`: many views, and parts that several machines draw.

#include <gtest/gtest.h>

#include <string>

#include "tests/command_fixture.h"

namespace {

TEST_F(Command, TurntableDrawsNumberedViews) {
  write("t.draw",
        "set-window -1 1 -1 1\nset-line-style none\nopen-segment 1\n"
        "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0 0.5 0\n"
        "polygon-abs-3 0 -0.5 -0.5  0 0.5 0  0 -0.5 0.5\nclose-segment\n");
  EXPECT_EQ(run("draw t.draw --turntable 4 -o t.png --size 32x32 --ids i.npy --depth z.npy "
                "--stats"),
            0)
      << err_;
  EXPECT_NE(out_.find("views              4, from 1 tree"), std::string::npos) << out_;
  for (const char* file : {"t-000.png", "t-003.png", "i-002.npy", "z-001.npy"}) {
    EXPECT_TRUE(fs::exists(folder_ / file)) << file;
  }
  EXPECT_FALSE(fs::exists(folder_ / "t-004.png"));
  EXPECT_FALSE(fs::exists(folder_ / "t.png"));
  // The first view is the program's own; half a turn later it is another.
  EXPECT_EQ(run("draw t.draw -o t.png --size 32x32 --ids i.npy --hidden bsp"), 0) << err_;
  EXPECT_EQ(run("compare t.png t-000.png"), 0);
  EXPECT_EQ(run("compare i.npy i-000.npy"), 0);
  EXPECT_EQ(run("compare i.npy i-001.npy"), 1);
  for (const char* format : {"ppm", "svg", "pdf"}) {
    const std::string name = std::string("u.") + format;
    EXPECT_EQ(run("draw t.draw --turntable 2 -o " + name), 0) << err_;
    EXPECT_GT(fs::file_size(folder_ / (std::string("u-001.") + format)), 100u);
  }
  EXPECT_EQ(run("draw t.draw --turntable 1001 --size 1x1 -o v.ppm"), 0) << err_;
  EXPECT_TRUE(fs::exists(folder_ / "v-0000.ppm"));
  EXPECT_TRUE(fs::exists(folder_ / "v-1000.ppm"));
}

/// The views are those of a tree, lines and all, drawn by any method that works in image space.
TEST_F(Command, TurntableDrawsViewsWithoutASort) {
  write(
      "t.draw",
      "set-perspective 0.3 0.4 3\nset-light 1 2 3\nopen-segment 1\n"
      "set-fill-style solid 0.9 0.5 0.2\npolygon-abs-3 -0.8 -0.7 0.3  0.7 -0.6 -0.4  0.1 0.8 0.2\n"
      "set-fill-style solid 0.2 0.5 0.9\npolygon-abs-3 0.6 -0.7 0.4  -0.7 -0.5 -0.3  -0.1 0.7 0\n"
      "close-segment\n");
  const std::string turned = "draw t.draw --turntable 3 --size 60x50 ";
  EXPECT_EQ(run(turned + "-o t.png --ids t.npy --depth td.npy"), 0) << err_;
  for (const std::string method : {"z-buffer", "scan-line", "ray-cast"}) {
    EXPECT_EQ(
        run(turned + "-o v.png --ids v.npy --depth vd.npy --threads 2 --stats --hidden " + method),
        0)
        << err_;
    EXPECT_NE(out_.find("each viewed anew and not sorted"), std::string::npos) << out_;
    for (const char* view : {"-000.npy", "-001.npy", "-002.npy"}) {
      EXPECT_EQ(run(std::string("compare t") + view + " v" + view), 0) << method << out_;
    }
  }
  for (const std::string file : {".png --samples 2", ".svg"}) {
    ASSERT_EQ(run(turned + "--hidden z-buffer -o v" + file), 0) << err_;
    ASSERT_EQ(run("draw t.draw --size 60x50 --hidden z-buffer -o f" + file), 0) << err_;
    const std::string format = file.substr(0, 4);
    EXPECT_EQ(read(folder_ / ("v-000" + format)), read(folder_ / ("f" + format)));
    EXPECT_NE(read(folder_ / ("v-001" + format)), read(folder_ / ("f" + format)));
  }
  expect_error(turned + "-o w.png --hidden depth-sort", "not by depth-sort: expected bsp");
  EXPECT_FALSE(fs::exists(folder_ / "w-000.png"));
}

/// Each view equals a new drawing in it: the first view of a turn is the program's own.
TEST_F(Command, TurntableDrawsLines) {
  const std::string box =
      "polygon-abs-3 0 0 0  1 0 0  1 1 0  0 1 0\npolygon-abs-3 0 0 0  0 1 0  0 1 -1  0 0 -1\n"
      "polygon-abs-3 1 0 0  1 0 -1  1 1 -1  1 1 0\npolygon-abs-3 0 1 0  1 1 0  1 1 -1  0 1 -1\n";
  const std::string segments = "open-segment 1\n" + box +
                               "close-segment\ntranslate-3 -0.6 -0.5 0.4\nopen-segment 2\n" + box +
                               "close-segment\n";
  const std::string eye = "set-perspective 2 1.5 6\nset-window -2 2 -2 2\n";
  write("t.draw", eye + segments);
  write("own.draw", eye + "set-hidden-line-removal on\nset-hidden-method roberts\n" + segments);
  const auto same = [&](const std::string& a, const std::string& b) {
    EXPECT_EQ(read(folder_ / a), read(folder_ / b)) << a << " " << b;
  };
  for (const std::string method : {"roberts", "franklin"}) {
    for (const std::string format : {"png", "svg"}) {
      const std::string by = "--size 60x50 --hidden " + method;
      EXPECT_EQ(run("draw t.draw -o f." + format + " " + by), 0) << err_;
      EXPECT_EQ(run("draw t.draw -o t." + format + " --turntable 3 --stats " + by), 0) << err_;
      same("f." + format, "t-000." + format);
      EXPECT_NE(read(folder_ / ("t-001." + format)), read(folder_ / ("t-000." + format)));
      for (const char* view : {"-001.", "-002."}) {
        if (method == "franklin") same("t" + (view + format), "r" + (view + format));
        fs::rename(folder_ / ("t" + (view + format)), folder_ / ("r" + (view + format)));
      }
    }
  }
  EXPECT_EQ(run("draw own.draw -o f.svg --size 60x50"), 0) << err_;
  EXPECT_EQ(run("draw own.draw -o own.svg --turntable 2 --size 60x50"), 0) << err_;
  same("f.svg", "own-000.svg");
  expect_error("draw t.draw -o x.png --turntable 2 --hidden franklin --ids x.npy",
               "item buffers and depths are of fills");
  expect_error("draw own.draw -o x.png --turntable 2 --ids x.npy",
               "item buffers and depths are of fills");
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  EXPECT_EQ(run("draw m.obj -o m.svg --turntable 2 --hidden franklin"), 0) << err_;
  EXPECT_NE(read(folder_ / "m-001.svg").find("<path"), std::string::npos);
}

/// Machines that draw only some views, or some rows, each draw the same as one that draws all.
TEST_F(Command, SomeViewsAndSomeRowsAreThoseOfAll) {
  write("a.draw",
        "set-perspective 0 0 5\nopen-segment 1\n"
        "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0.3  0 0.5 0\n"
        "polygon-abs-3 -0.5 0.5 0.2  0.5 0.5 0  0 -0.5 0.1\nclose-segment\n");
  ASSERT_EQ(run("draw a.draw -o all.png --turntable 7 --size 30x30"), 0) << err_;
  ASSERT_EQ(run("draw a.draw -o some.png --turntable 7 --views 0:3 --size 30x30"), 0) << err_;
  ASSERT_EQ(run("draw a.draw -o some.png --turntable 7 --views 3:7 --size 30x30"), 0) << err_;
  for (int k = 0; k < 7; ++k) {
    const std::string number = "-00" + std::to_string(k) + ".png";
    EXPECT_TRUE(read(folder_ / ("all" + number)) == read(folder_ / ("some" + number))) << k;
  }
  ASSERT_EQ(run("draw a.draw -o whole.ppm --size 30x30"), 0) << err_;
  std::string parts = "P6\n30 30\n255\n";
  for (const std::string rows : {"0:11", "11:30"}) {
    ASSERT_EQ(run("draw a.draw -o part.ppm --size 30x30 --rows " + rows), 0) << err_;
    const std::string part = read(folder_ / "part.ppm");
    parts += part.substr(part.find("255\n") + 4);
  }
  EXPECT_TRUE(read(folder_ / "whole.ppm") == parts);
  for (const std::string rows :
       {"", "3", "3:", ":3", "3:3", "5:2", "0:31", "-1:3", "0:3x", "a:b"}) {
    expect_error("draw a.draw -o b.png --size 30x30 --rows '" + rows + "'", "expected FIRST:END");
    expect_error("draw a.draw -o b.png --turntable 30 --views '" + rows + "'",
                 "expected FIRST:END");
  }
  expect_error("draw a.draw -o b.svg --rows 0:3", "vectors have no rows");
  expect_error("draw a.draw -o b.png --views 0:3", "expected --turntable");
}

TEST_F(Command, TurntableExplainsItsMethod) {
  write("t.draw", kTriangle);
  ASSERT_EQ(run("draw t.draw -o t.png --size 9x9 --turntable 2 --explain"), 0) << err_;
  EXPECT_EQ(out_,
            "auto: bsp: a turntable's views are drawn from one BSP tree in world coordinates\n");
  ASSERT_EQ(run("draw t.draw -o t.png --size 9x9 --turntable 2 --explain --hidden z-buffer"), 0);
  EXPECT_EQ(out_, "z-buffer: as set\n");
  ASSERT_EQ(run("draw t.draw -o t.svg --turntable 2 --explain --pens"), 0) << err_;
  EXPECT_EQ(out_, "franklin: for pens: visible lines only\n");
  expect_error("draw t.draw -o t.png --turntable 2 --pick 1,1",
               "--pick 1,1: expected one picture, and not a turntable's views");
}

/// Its files are those with numbers.
TEST_F(Command, TurntableDrawsIntoFilesOfTheirOwn) {
  write("t.draw", kTriangle);
  const std::string other = "open-segment 2\npolygon-abs-3 0 0 0  1 0 0  0 1 1\nclose-segment\n";
  write("b-001.draw", other);
  const std::string of_two = " -o b.draw --format svg --size 9x9 --turntable 2";
  expect_error("draw t.draw b-001.draw" + of_two, "b-001.draw: is an input and an output");
  EXPECT_EQ(read(folder_ / "b-001.draw"), other);
  expect_error("draw t.draw -o a.png --ids a.png --turntable 2", "two outputs are one file");
  ASSERT_EQ(run("draw t.draw b-001.draw" + of_two + " --views 0:1"), 0) << err_;
  EXPECT_EQ(read(folder_ / "b-001.draw"), other);
  // A picture of each input: one of the first's views is the second.
  write("b.draw", kTriangle);
  expect_error("draw b.draw b-001.draw -o '{name}.draw' --format svg --turntable 2",
               "b-001.draw: the output of b.draw and an input");
  EXPECT_EQ(read(folder_ / "b-001.draw"), other);
}

TEST_F(Command, TurntableRefuses) {
  write("t.draw", kTriangle);
  for (const char* views : {"0", "-1", "10001", "99999999999999999999", "nan", "1e2", "4.5"}) {
    expect_error(std::string("draw t.draw -o t.png --turntable ") + views,
                 "expected a number of views, 1 to 10000");
  }
  expect_error("draw t.draw -o t.png --turntable 3 --hidden depth-sort", "from one BSP tree");
  expect_error("draw t.draw -o t.gif --turntable 3", "t.gif");
  expect_error("draw t.draw -o nowhere/t.png --turntable 3", "nowhere/t-000.png");
  fs::create_directories(folder_ / "t-002.png");
  expect_error("draw t.draw -o t.png --turntable 3", "t-002.png");
  write("two.draw", kTriangle +
                        "set-window 0 2 0 2\nopen-segment 2\n"
                        "polygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n");
  expect_error("draw two.draw -o two.png --turntable 3", "different views");
}

TEST_F(Command, ATurntableDrawsASurfaceInCurvesWhateverWasDeleted) {
  write("s.draw",
        "set-perspective 3 4 6\nset-window -3 3 -3 3\nset-hidden-line-removal on\nrotate-x-3 -90\n"
        "open-segment 1\nbox-3 5 6 5 6 5 6\nclose-segment\nopen-segment 2\n"
        "surface-3 -1 1 3 -1 1 3  0 .1 0 .2 .5 .1 0 .3 0\nclose-segment\ndelete-segment 1\n");
  EXPECT_EQ(run("draw s.draw -o t.svg --turntable 3 --hidden perimeter"), 0) << err_;
  ASSERT_EQ(run("draw s.draw -o s.svg --hidden perimeter"), 0) << err_;
  EXPECT_EQ(read(folder_ / "t-000.svg"), read(folder_ / "s.svg"));
}

TEST_F(Command, ATurntableSaysWhatAPictureSays) {
  write("t.draw", "set-precision roundoff=1e-6\n" + kTriangle);
  const std::string exact = "precision exact";
  expect_error("draw t.draw -o x.png --hidden world-ray-cast", exact);
  expect_error("draw t.draw -o x.png --hidden world-ray-cast --turntable 2", exact);
  write("u.draw", kTriangle);
  EXPECT_EQ(run("draw u.draw -o x.png --turntable 2 --explain --hidden colour-rule"), 0) << err_;
  EXPECT_TRUE((out_ + err_).find("colour-rule: ") != std::string::npos) << out_ << err_;
}

}  // namespace
