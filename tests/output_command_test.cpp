// The command's outputs: files of their own, whole or absent, and the messages about them.

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>

#include "clip/point.h"
#include "tests/command_fixture.h"

namespace {

/// Unless one sample is set; item buffers are the same.
TEST_F(Command, PixelsAreAntialiased) {
  write("t.draw", kTriangle);
  EXPECT_EQ(run("draw t.draw -o usual.ppm --size 40x40 --ids usual.npy"), 0) << err_;
  EXPECT_EQ(run("draw t.draw -o four.ppm --size 40x40 --samples 4"), 0) << err_;
  EXPECT_EQ(run("draw t.draw -o one.ppm --size 40x40 --ids one.npy --samples 1"), 0) << err_;
  EXPECT_EQ(read(folder_ / "usual.ppm"), read(folder_ / "four.ppm"));
  EXPECT_NE(read(folder_ / "usual.ppm"), read(folder_ / "one.ppm"));
  EXPECT_EQ(read(folder_ / "usual.npy"), read(folder_ / "one.npy"));
  EXPECT_EQ(run("draw t.draw -o plain.ppm --size 40x40 --hidden plain-z-buffer"), 0) << err_;
  EXPECT_EQ(read(folder_ / "plain.ppm"), read(folder_ / "one.ppm"));
  EXPECT_EQ(run("draw t.draw -o t.svg"), 0) << err_;
  EXPECT_EQ(err_, "");  // vectors leave out no samples that were set
}

/// Whatever command prints it.
TEST_F(Command, AReportThatCannotBeWrittenIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  write("t.draw", kTriangle);
  ASSERT_EQ(run("dump t.draw -o t.txt"), 0) << err_;
  for (const char* line :
       {"dump t.draw", "draw t.draw -o t.png --size 9x9 --stats",
        "draw t.draw -o t.png --size 9x9 --explain", "draw t.draw -o t.png --size 9x9 --pick 4,4",
        "check t.draw --golden t.txt --summary", "truth t.draw --size 9x9 --hidden franklin",
        "compare t.txt t.txt", "--version", "draw --help"}) {
    const int status = std::system(("cd '" + folder_.string() + "' && '" DISPLAYFILE_COMMAND "' " +
                                    line + " >/dev/full 2>.err")
                                       .c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2) << line;
    EXPECT_EQ(read(folder_ / ".err"), "displayfile: standard output: not all could be written\n")
        << line;
  }
}

/// One that is lost would be no error otherwise.
TEST_F(Command, OutputsAreFilesOfTheirOwn) {
  write("t.draw", kTriangle);
  fs::create_symlink("x.png", folder_ / "link.png");
  fs::create_directory(folder_ / "sub");
  const std::string root = folder_.string();
  const std::string one_file = ": two outputs are one file: expected a file for each";
  expect_error("draw t.draw -o x.png --ids ./x.png", "x.png and ./x.png" + one_file);
  expect_error("draw t.draw -o x.png --ids i.npy --depth sub/../i.npy", one_file);
  expect_error("draw t.draw -o x.png --ids link.png", "x.png and link.png" + one_file);
  expect_error("draw t.draw -o '" + root + "/x.png' --ids x.png", one_file);
  expect_error("truth t.draw --ids i.npy --depth ./i.npy", one_file);
  expect_error("truth t.draw --ids - --depth -", "-: two outputs on standard output");
  expect_error("truth t.draw --ids - --depth /dev/stdout", "two outputs");
  expect_error("compare - -", "-: standard input is read twice", "t.draw");
  expect_error("surface x -o x.draw --program x.draw", "x.draw");
  EXPECT_EQ(run("draw t.draw -o x.ppm --size 9x9 --ids /dev/null --depth /dev/null"), 0) << err_;

  const std::string is_input = ": is an input and an output: expected another file";
  fs::create_symlink("t.draw", folder_ / "same.draw");
  expect_error("dump t.draw -o ./t.draw", "./t.draw" + is_input);
  expect_error("dump same.draw -o t.draw", "t.draw" + is_input);
  expect_error("draw t.draw -o t.draw --format svg", "t.draw" + is_input);
  expect_error("draw t.draw same.draw -o '{name}.draw' --format svg",
               "t.draw: the output of t.draw and an input");
  ASSERT_EQ(run("draw t.draw -o a.png --size 9x9"), 0) << err_;
  expect_error("compare a.png a.png --marks a.png", "a.png" + is_input);
  // So is a list of inputs, whatever it is called.
  for (const char* list : {"names.txt", "names.svg", "names.npy", "names.html"}) {
    write(list, "t.draw\n");
  }
  write("names.draw", "m.obj\n");
  expect_error("dump @names.txt -o names.txt", "names.txt" + is_input);
  expect_error("draw @names.svg -o ./names.svg", "./names.svg" + is_input);
  expect_error("draw t.draw -o x.png @names.npy --ids names.npy", "names.npy" + is_input);
  expect_error("truth @names.npy --ids names.npy", "names.npy" + is_input);
  expect_error("page @names.html -o names.html", "names.html" + is_input);
  expect_error("steps @names.html -o names.html --hidden bsp", "names.html" + is_input);
  expect_error("import @names.draw -o names.draw", "names.draw" + is_input);
  expect_error("sheet @names.svg -o names.svg", "names.svg" + is_input);
  write("t.svg", "t.draw\n");
  expect_error("draw @t.svg -o '{name}.svg'", "t.svg: the output of t.draw and an input");
  EXPECT_EQ(read(folder_ / "names.txt"), "t.draw\n");
  EXPECT_EQ(read(folder_ / "t.draw"), kTriangle);

  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_error("page t.draw -o t.draw", "t.draw: expected a page that ends in .html, or -");
  expect_error("import m.obj -o m.obj", "m.obj: expected a drawing program that ends in .draw");
  expect_error("surface x -o x.svg --program x.png", "x.png: expected a drawing program that ends");
  expect_error("draw - - -o x.png", "-: standard input is read twice: expected it once");
}

/// No file that is opened replaces a closed standard error: messages are in no file.
TEST_F(Command, ClosedStandardErrorIsInNoPicture) {
  std::string inputs;
  for (int k = 0; k < 16; ++k) {
    inputs += fmt::format(" t{}.draw", k);
    write(fmt::format("t{}.draw", k), "set-window 0 2 0 1\n" + kTriangle);
  }
  for (const char* folder : {"said", "closed"}) fs::create_directory(folder_ / folder);
  const auto draw_into = [&](const std::string& folder, const std::string& standard_error) {
    const std::string line = "cd '" + folder_.string() + "' && '" DISPLAYFILE_COMMAND "' draw" +
                             inputs + " -o '" + folder + "/{name}.ppm' --size 900x300 2>" +
                             standard_error;
    return std::system(line.c_str());
  };
  EXPECT_EQ(draw_into("said", ".err"), 0);
  EXPECT_EQ(draw_into("closed", "&-"), 0);
  for (int k = 0; k < 16; ++k) {
    const std::string name = fmt::format("t{}.ppm", k);
    EXPECT_TRUE(read(folder_ / "said" / name) == read(folder_ / "closed" / name)) << name;
  }
}

TEST_F(Command, AFailedRunLeavesTheOldOutput) {
  write("t.draw", kTriangle);
  EXPECT_EQ(run("draw t.draw -o x.png"), 0);
  const std::string before = read(folder_ / "x.png");
  write("t.draw", "nonsense\n");
  EXPECT_EQ(run("draw t.draw -o x.png"), 2);
  EXPECT_EQ(read(folder_ / "x.png"), before);
}

/// All outputs of a command or none.
TEST_F(Command, TruthWritesAllOrNothing) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  write("t.draw", kTriangle);
  write("old", "old");
  fs::create_symlink("/dev/full", folder_ / "full");
  for (const std::string outputs :
       {"--ids old --depth full", "--seen-lines old --ids full", "--ids full --seen-lines old"}) {
    EXPECT_EQ(run("truth t.draw --size 32x32 " + outputs), 2) << outputs;
    EXPECT_NE(err_.find("full"), std::string::npos) << err_;
    EXPECT_EQ(read(folder_ / "old"), "old") << outputs;
  }
  EXPECT_EQ(run("truth t.draw --size 32x32 --ids - --hidden franklin"), 0);
  EXPECT_TRUE(out_.starts_with("\x93NUMPY")) << out_.substr(0, 100);
  EXPECT_NE(err_.find("missing length  0"), std::string::npos) << err_;
}

/// A standard stream that is a file may not be another output, or an input; and its contents stay.
TEST_F(Command, StandardStreamsThatAreFilesAreFilesOfTheirOwn) {
  write("t.draw", kTriangle);
  write("s.draw", kTriangle);
  const auto shell = [&](const std::string& arguments) {
    const std::string line =
        "cd '" + folder_.string() + "' && '" DISPLAYFILE_COMMAND "' " + arguments;
    const int status = std::system((line + " 2>.err").c_str());
    err_ = read(folder_ / ".err");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  EXPECT_EQ(shell("draw t.draw -o - --format svg --ids f.npy >f.npy"), 2);
  EXPECT_NE(err_.find("two outputs"), err_.npos) << err_;
  EXPECT_EQ(shell("draw t.draw -o p.svg --ids /dev/stdout >p.svg"), 2);
  EXPECT_EQ(shell("draw - -o s.draw --format svg <s.draw"), 2);
  EXPECT_NE(err_.find("input"), err_.npos) << err_;
  EXPECT_EQ(read(folder_ / "s.draw"), kTriangle);
  write("log", "old\n");
  EXPECT_EQ(shell("draw t.draw -o /dev/stdout --format svg >>log"), 0) << err_;
  EXPECT_TRUE(read(folder_ / "log").starts_with("old\n<"));
}

TEST_F(Command, WhatAPictureLeavesOutIsTold) {
  write("t.draw", kTriangle);
  ASSERT_EQ(run("draw t.draw -o x.png --pick-ids --seams butted --vector-precision 0.5"), 0);
  EXPECT_NE(err_.find("x.png: pixels leave out --pick-ids, --seams, --vector-precision\n"),
            err_.npos)
      << err_;
  ASSERT_EQ(run("draw t.draw -o x.svg --pick-ids --hidden bsp"), 0);
  EXPECT_NE(err_.find("x.svg: vectors leave out --pick-ids"), err_.npos) << err_;
  ASSERT_EQ(run("draw t.draw -o x.svg --pick-ids --hidden map"), 0);
  EXPECT_EQ(err_, "");
}

TEST_F(Command, EpsIsAFormatOfVectors) {
  write("t.draw", kTriangle);
  EXPECT_EQ(run("draw t.draw -o t.eps --hidden bsp --size 64x48"), 0) << err_;
  const std::string eps = read(folder_ / "t.eps");
  EXPECT_TRUE(eps.starts_with("%!PS-Adobe-3.0 EPSF-3.0"));
  EXPECT_NE(eps.find("%%BoundingBox: 0 0 64 48"), std::string::npos) << eps.substr(0, 400);
}

/// Whatever is drawn: a picture of lines only, and an empty one.
TEST_F(Command, AnEpsWithoutABackgroundHasTheSizeAskedFor) {
  write("line.draw", "open-segment 1\nmove-abs-2 0.3 0.3\nline-abs-2 0.6 0.6\nclose-segment\n");
  write("nothing.draw", "open-segment 1\nclose-segment\n");
  for (const std::string name : {"line", "nothing"}) {
    ASSERT_EQ(run("draw " + name + ".draw -o a.eps --background none --size 300x200"), 0) << err_;
    std::istringstream lines(read(folder_ / "a.eps"));
    int boxes = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line.find("BoundingBox:") == std::string::npos) continue;
      ++boxes;
      EXPECT_TRUE(line.ends_with("BoundingBox: 0 0 300 200")) << name << ": " << line;
    }
    EXPECT_GE(boxes, 2) << name;
  }
}

/// The box of whole points covers the sheet; the one of fractions is the sheet, and lengths are
/// true.
TEST_F(Command, AnEpsHasASizeOnPaper) {
  write("line.draw",
        "set-window -50 50 -30 30\nset-window-fit widen\nset-line-style solid 0 0 0\n"
        "open-segment 1\nmove-abs-3 -40 -20 0\nline-abs-3 40 20 0\nclose-segment\n");
  const std::string line = "draw line.draw --size 120.5x80mm --scale 1:1 --line-width 2pt -o a.eps";
  ASSERT_EQ(run(line), 0) << err_;
  std::istringstream lines(read(folder_ / "a.eps"));
  constexpr double kPerMillimetre = 72.0 / 25.4, kNear = 0.01 * kPerMillimetre;
  double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0, width = 0.0;
  displayfile::Point2 from(0.0), to(0.0);
  for (std::string text; std::getline(lines, text);) {
    if (std::sscanf(text.c_str(), "%%%%HiResBoundingBox: %lf %lf %lf %lf", &left, &bottom, &right,
                    &top) == 4) {
      continue;
    }
    if (text.starts_with("%%BoundingBox: ")) {
      EXPECT_EQ(text, "%%BoundingBox: 0 0 342 227");
    }
    double number = 0.0;
    int length = 0;
    std::sscanf(text.c_str(), "%lf w%n", &number, &length);
    if (length > 0) width = number;
    std::sscanf(text.c_str(), "%lf %lf m %lf %lf l S", &from.x, &from.y, &to.x, &to.y);
  }
  EXPECT_NEAR(right - left, 120.5 * kPerMillimetre, kNear);
  EXPECT_NEAR(top - bottom, 80.0 * kPerMillimetre, kNear);
  EXPECT_EQ(width, 2.0);
  EXPECT_NEAR(to.x - from.x, 80.0 * kPerMillimetre, kNear);
  EXPECT_NEAR(from.y - to.y, 40.0 * kPerMillimetre, kNear);
  // The page's coordinates are 227 points down from the box's top.
  EXPECT_NEAR(0.5 * (from.x + to.x), 0.5 * (left + right), kNear);
  EXPECT_NEAR(227.0 - 0.5 * (from.y + to.y), 0.5 * (bottom + top), kNear);
  expect_error("draw line.draw -o a.eps --pens", "a.eps: .eps files are not for pens: expected");
}

}  // namespace
