// `displayfile surface`: expressions and grids, their axes and other additions, and refused
// arguments.

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "interp/files/npy_file.h"
#include "tests/command_fixture.h"

namespace {

class SurfaceCommandTest : public Command {
 protected:
  /// Draws, and counts the occurrences of a routine in the drawing program.
  std::size_t count(const std::string& arguments, const std::string& routine) {
    EXPECT_EQ(run("surface " + arguments + " -o s.svg --program s.draw"), 0) << err_;
    std::istringstream lines(read(folder_ / "s.draw"));
    std::size_t found = 0;
    for (std::string line; std::getline(lines, line);) found += line.starts_with(routine + " ");
    return found;
  }

  void refuses(const std::string& arguments, const std::string& expected) {
    EXPECT_EQ(run("surface " + arguments), 2) << arguments;
    EXPECT_NE(err_.find(expected), std::string::npos) << err_;
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_FALSE(fs::exists(folder_ / "s.svg"));
    EXPECT_FALSE(fs::exists(folder_ / "s.draw"));
  }

  /// True if this build reads expressions.
  bool reads_expressions() {
    const bool reads = can_run("surface x -o s.svg", "this build has no muParser");
    fs::remove(folder_ / "s.svg");
    return reads;
  }
};

TEST_F(SurfaceCommandTest, AnExpressionIsItsHeights) {
  if (!reads_expressions()) GTEST_SKIP() << "no muParser";
  ASSERT_EQ(run("surface 'x^2 - 2*y + pi' --x 0:2 --y -1:1 --grid 3x2 -o s.svg --program s.draw "
                "--no-axes --no-box"),
            0)
      << err_;
  const std::string program = read(folder_ / "s.draw");
  const std::string heights =
      "surface-3 0 2 3 -1 1 2 5.141592653589793 6.141592653589793 9.141592653589793 "
      "1.1415926535897931 2.141592653589793 5.141592653589793\n";
  EXPECT_NE(program.find(heights), std::string::npos) << program;
  EXPECT_EQ(run("draw s.draw -o again.svg --hidden perimeter --size 640x480"), 0) << err_;
  EXPECT_EQ(read(folder_ / "again.svg"), read(folder_ / "s.svg"));
}

/// With any options, and without repeating them.
TEST_F(SurfaceCommandTest, TheProgramDrawsTheSamePicture) {
  write("g.txt", "0 1 2 1\n1 2 5 2\n0 1 nan 4\n");
  write("h.txt", "2 1 0 3\n3 0 1 2\n1 4 2 0\n");
  for (const std::string arguments :
       {"h.txt", "g.txt", "g.txt h.txt", "g.txt h.txt --hidden z-buffer", "h.txt --colour height",
        "h.txt --hidden franklin --hidden-lines dashed --lines outline", "h.txt --sides upper",
        "h.txt --background '#ccddee' --precision roundoff=1e-6", "h.txt --hidden none"}) {
    SCOPED_TRACE(arguments);
    ASSERT_EQ(run("surface " + arguments + " -o s.svg --program s.draw"), 0) << err_;
    ASSERT_EQ(run("draw s.draw -o again.svg --size 640x480"), 0) << err_;
    EXPECT_EQ(read(folder_ / "again.svg"), read(folder_ / "s.svg"));
  }
}

/// The heights that are not known are in the program as holes, whatever sign their bits have.
TEST_F(SurfaceCommandTest, TheProgramOfAnExpressionWithHolesDrawsTheSame) {
  if (!reads_expressions()) GTEST_SKIP() << "no muParser";
  for (const char* expression : {"'sqrt(x)'", "'0-sqrt(x)'"}) {
    ASSERT_EQ(run("surface " + std::string(expression) + " -o s.svg --program s.draw"), 0) << err_;
    ASSERT_EQ(run("draw s.draw -o again.svg --size 640x480"), 0) << err_;
    EXPECT_EQ(read(folder_ / "again.svg"), read(folder_ / "s.svg"));
  }
}

/// It sees world coordinates: the surface is kept in them.
TEST_F(SurfaceCommandTest, IsDrawnByRaysInTheWorld) {
  write("g.txt", "0 1 2\n1 3 2\n0 1 1\n");
  ASSERT_EQ(run("surface g.txt -o w.png --size 90x90 --hidden world-ray-cast --program s.draw"), 0)
      << err_;
  ASSERT_EQ(run("draw s.draw -o again.png --size 90x90"), 0) << err_;
  EXPECT_EQ(read(folder_ / "again.png"), read(folder_ / "w.png"));
  const std::string both = "surface g.txt g.txt --lines outline --size 90x90 --program s.draw ";
  ASSERT_EQ(run(both + "-o both.png --hidden world-ray-cast"), 0) << err_;
  ASSERT_EQ(run("draw s.draw -o again.png --size 90x90"), 0) << err_;
  EXPECT_EQ(read(folder_ / "again.png"), read(folder_ / "both.png"));
  EXPECT_NE(read(folder_ / "both.png"), read(folder_ / "w.png"));  // it has no curves
}

/// Between two commas, before the first and after the last may be nothing: no height moves to
/// another column.
TEST_F(SurfaceCommandTest, AMissingCellIsAHole) {
  write("holes.txt", "1 nan 3\nnan 5 6\n7 8 nan\n9 9 9\n");
  ASSERT_EQ(run("surface holes.txt -o s.svg --program s.draw"), 0) << err_;
  const std::string program = read(folder_ / "s.draw");
  for (const char* rows : {"1,,3\n,5,6\n7,8,\n9,9,9\n", "1, ,3\r\n ,5 , 6\r\n7,8,\t\r\n9,9,9\r\n",
                           "1;;3 # a remark\n;5;6\n7;8;\n\n 9  9\t 9 # tabs and blanks\n",
                           "\xEF\xBB\xBF"
                           "1,,3\n,5,6\n7,8, # the last is not known\n9,9,9"}) {
    write("g.csv", rows);
    ASSERT_EQ(run("surface g.csv -o s.svg --program s.draw"), 0) << rows << err_;
    EXPECT_EQ(read(folder_ / "s.draw"), program) << rows;
  }
  fs::remove(folder_ / "s.svg");
  fs::remove(folder_ / "s.draw");
  write("g.csv", "1;2\n0,5;1,5\n");
  refuses("g.csv -o s.svg",
          "g.csv:2:4: ';' in a row with ',': expected one of them between heights, and a point "
          "before decimals");
}

/// A file of that name that is no grid makes no difference to an expression.
TEST_F(SurfaceCommandTest, AnExpressionMayBeCalledAsAFileIs) {
  if (!reads_expressions()) GTEST_SKIP() << "no muParser";
  ASSERT_EQ(run("surface x 'x*y' -o before.svg"), 0) << err_;
  fs::create_directory(folder_ / "x");
  write("x*y", "any text");
  ASSERT_EQ(run("surface x 'x*y' -o s.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "s.svg"), read(folder_ / "before.svg"));
}

TEST_F(SurfaceCommandTest, ATextAndAnArrayAreTheSame) {
  write("g.txt", "# heights\n0 1, 2\n3;4\t5e0 # the last row\n");
  const std::vector<double> heights{0, 1, 2, 3, 4, 5};
  displayfile::write_npy(heights, 3, 2, folder_ / "g.npy");
  ASSERT_EQ(run("surface g.txt -o t.svg"), 0) << err_;
  ASSERT_EQ(run("surface g.npy -o n.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "t.svg"), read(folder_ / "n.svg"));
}

TEST_F(SurfaceCommandTest, AllFormatsAndMethodsDrawIt) {
  write("g.txt", "0 1 0\n1 2 1\n0 1 0\n");
  for (const auto& [name, begin] :
       {std::pair("a.svg", "<?xml "), std::pair("a.pdf", "%PDF-"), std::pair("a.eps", "%!PS-Adobe"),
        std::pair("a.png", "\x89PNG\r\n"), std::pair("a.ppm", "P6\n640 480\n255\n")}) {
    const std::string arguments = std::string(" --size 640x480 -o ") + name;
    ASSERT_EQ(run("surface g.txt --colour height --program s.draw" + arguments), 0) << err_;
    const std::string coloured = read(folder_ / name);
    EXPECT_TRUE(coloured.starts_with(begin)) << name;
    ASSERT_EQ(run("draw s.draw" + arguments), 0) << err_;
    EXPECT_EQ(read(folder_ / name), coloured) << name;
    ASSERT_EQ(run("surface g.txt" + arguments), 0) << err_;
    EXPECT_NE(read(folder_ / name), coloured) << name;  // without colours
  }
  ASSERT_EQ(run("surface g.txt -o p.svg"), 0) << err_;
  for (const char* method : {"franklin", "roberts", "appel", "perimeter"}) {
    ASSERT_EQ(run(std::string("surface g.txt -o m.svg --hidden ") + method), 0) << err_;
    EXPECT_EQ(read(folder_ / "m.svg"), read(folder_ / "p.svg")) << method;
  }
}

TEST_F(SurfaceCommandTest, TellsThatPensLeaveOutTexts) {
  write("g.txt", "0 1 0\n1 2 1\n0 1 0\n");
  ASSERT_EQ(run("surface g.txt -o s.svg --pens"), 0) << err_;
  EXPECT_NE(err_.find("s.svg: vectors leave out texts"), std::string::npos) << err_;
  for (const char* arguments : {"-o s.svg --pens --no-axes", "-o s.svg", "-o s.png"}) {
    ASSERT_EQ(run(std::string("surface g.txt ") + arguments), 0) << err_;
    EXPECT_EQ(err_, "") << arguments;
  }
}

TEST_F(SurfaceCommandTest, AHoleIsDrawnByAnotherMethod) {
  write("g.txt", "0 1 0\n1 nan 1\n0 1 0\n2 2 2\n");
  ASSERT_EQ(run("surface g.txt -o s.svg"), 0) << err_;
  ASSERT_EQ(run("surface g.txt -o f.svg --hidden franklin"), 0) << err_;
  EXPECT_EQ(read(folder_ / "s.svg"), read(folder_ / "f.svg"));
  expect_error("surface g.txt -o p.svg --hidden perimeter", "whole and of solid cells");
}

TEST_F(SurfaceCommandTest, OneCellAndAFlatSurfaceAreDrawn) {
  write("cell.txt", "0 1\n1 0\n");
  write("flat.txt", "3 3\n3 3\n");
  for (const char* options : {"", "--colour height", "--contours 5", "--eye 0,90", "--eye 0,0"}) {
    for (const std::string grid : {"cell.txt ", "flat.txt "}) {
      SCOPED_TRACE(grid + options);
      EXPECT_EQ(count(grid + options, "surface-3"), 1u);
      const std::string drawn = read(folder_ / "s.svg");
      ASSERT_EQ(run("surface --no-axes --no-box -o bare.svg " + grid + options), 0) << err_;
      const std::string surface = read(folder_ / "bare.svg");
      EXPECT_NE(surface.find("<path"), std::string::npos);
      EXPECT_GT(std::ranges::count(drawn, '\n'), std::ranges::count(surface, '\n'));
    }
  }
}

/// Before anything is evaluated, with the memory needed, the memory there is, and the number of
/// points that fits.
TEST_F(SurfaceCommandTest, AGridThatMemoryDoesNotHoldIsRefused) {
  if (!reads_expressions()) GTEST_SKIP() << "no muParser";
  before_ = "ulimit -v 2000000 && ";
  const std::string s = " -o s.svg --program s.draw";
  refuses("x --grid 10000x10000" + s,
          "out of memory: x: drawing 100000000 points needs 50 GB, and the system offers");
  refuses("x y --grid 1000x1000" + s, "y: drawing 2000000 points needs 2.6 GB");
  EXPECT_NE(err_.find("points or fewer"), std::string::npos) << err_;
}

/// Their line of intersection is drawn, unless other lines are selected.
TEST_F(SurfaceCommandTest, SurfacesThatPassThroughEachOtherShowWhere) {
  write("a.txt", "0 0\n1 1\n");
  write("b.txt", "1 1\n0 0\n");
  const std::string both = "surface a.txt b.txt --no-axes --no-box --size 400x400 -o ";
  ASSERT_EQ(run(both + "with.svg"), 0) << err_;
  ASSERT_EQ(run(both + "without.svg --lines all"), 0) << err_;
  EXPECT_NE(read(folder_ / "with.svg"), read(folder_ / "without.svg"));
  ASSERT_EQ(run(both + "asked.svg --lines all,intersection"), 0) << err_;
  EXPECT_EQ(read(folder_ / "with.svg"), read(folder_ / "asked.svg"));
}

/// Numbers of the legend are as round as those of the axes.
TEST_F(SurfaceCommandTest, TheLegendHasRoundNumbers) {
  write("g.txt", "0 0.37\n0.1 0.99\n");
  ASSERT_EQ(run("surface g.txt --colour height --no-axes -o s.svg --program s.draw"), 0) << err_;
  const std::string program = read(folder_ / "s.draw");
  for (const char* text : {"text \"0\"", "text \"0.2\"", "text \"0.8\""}) {
    EXPECT_NE(program.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(program.find("text \"0.99\""), std::string::npos);
}

/// Its margins and letters are smaller then.
TEST_F(SurfaceCommandTest, TheLegendIsBesideTheAxesInANarrowPictureToo) {
  write("g.txt", "-1 0 1\n0 0 0\n1 0 -1\n");
  for (const int width : {120, 200, 300, 400, 600, 900}) {
    const std::string size = " --size " + std::to_string(width) + "x800";
    ASSERT_EQ(run("surface g.txt --colour height -o s.svg --program s.draw" + size), 0) << err_;
    const std::string program = read(folder_ / "s.draw"), legend = "open-segment 2";
    std::istringstream bar(program.substr(program.find("polygon-abs-3", program.find(legend))));
    std::string routine;
    double left = 0.0;
    bar >> routine >> left;
    std::istringstream lines(read(folder_ / "s.svg"));
    int texts = 0;
    bool of_legend = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("<g id=")) of_legend = line.starts_with("<g id=\"segment-2-");
      const std::size_t x = line.find(" x=\"");
      if (!line.starts_with("<text") || of_legend || x == std::string::npos) continue;
      ++texts;
      EXPECT_LT(std::stod(line.substr(x + 4)), left * 800) << width << ": " << line;
    }
    EXPECT_GT(texts, 5) << width;
  }
}

TEST_F(SurfaceCommandTest, OptionsSayWhatIsDrawn) {
  write("g.txt", "0 1 0\n1 2 1\n0 1 0\n");
  EXPECT_GT(count("g.txt", "text"), 8u);
  EXPECT_EQ(count("g.txt --no-axes", "text"), 0u);
  EXPECT_EQ(count("g.txt --no-axes", "line-abs-3"), 9u);  // the box
  EXPECT_EQ(count("g.txt --no-axes --no-box", "line-abs-3"), 0u);
  EXPECT_GT(count("g.txt --no-axes --no-box --contours 3", "line-abs-3"), 8u);
  EXPECT_EQ(count("g.txt --colour height", "surface-3"), 4u);
  EXPECT_EQ(count("g.txt g.txt", "surface-3"), 2u);
  EXPECT_EQ(count("g.txt --curves x", "set-surface-curves"), 1u);
  EXPECT_EQ(count("g.txt --sides lower", "set-surface-sides"), 1u);
  EXPECT_EQ(count("g.txt --labels u,v,height", "text \"height\""), 0u);  // no blank follows
  EXPECT_NE(read(folder_ / "s.draw").find("text \"height\"\n"), std::string::npos);
  const std::size_t with_names = count("g.txt --labels east,north,h", "text");
  for (const std::string names : {",north,h", "east,,h", "east,north,"}) {  // an axis without one
    EXPECT_EQ(count("g.txt --labels " + names, "text"), with_names - 1) << names;
    const std::string program = read(folder_ / "s.draw");
    for (const std::string name : {"east", "north", "h"}) {
      EXPECT_EQ(program.find("text \"" + name + "\"") != std::string::npos,
                ("," + names + ",").find("," + name + ",") != std::string::npos)
          << names << ": " << name;
    }
  }
}

TEST_F(SurfaceCommandTest, WhatIsWrongIsToldAndNothingIsWritten) {
  write("g.txt", "0 1 0\n1 2 1\n0 1 0\n");
  const std::string s = " -o s.svg --program s.draw";
  refuses("g.txt --x 3:1" + s, "--x 3:1: expected A:B, two finite numbers, the first less");
  refuses("g.txt --y 1" + s, "--y 1: expected A:B");
  refuses("g.txt --z nan:1" + s, "--z nan:1: expected A:B");
  refuses("g.txt --grid 1x1" + s, "--grid 1x1: expected NXxNY points, 2 or more each way");
  refuses("g.txt --grid 5" + s, "--grid 5: expected");
  refuses("g.txt --curves z" + s, "curves of a surface are");
  refuses("g.txt --sides left" + s, "sides of a surface are");
  refuses("g.txt --colour red" + s, "--colour red: expected height");
  refuses("g.txt --contours x" + s, "--contours: x: expected a whole number");
  refuses("g.txt --contours 101" + s, "--contours 101: expected 0 to 100");
  refuses("g.txt --labels a,b" + s, "--labels a,b: expected three names");
  refuses("g.txt --labels a,b,c --no-axes" + s, "--labels a,b,c: expected axes or --colour");
  refuses("g.txt --eye here" + s, "--eye");
  refuses("g.txt --threads 0" + s, "0 threads: expected 1 or more");
  refuses("g.txt --samples 17" + s, "17 samples along a pixel's side: expected 1 to 16");
  refuses("g.txt --size 9" + s, "--size 9: expected WIDTHxHEIGHT");
  refuses("g.txt --background pinkish" + s, "--background pinkish: expected R,G,B");
  refuses("g.txt --paper a99" + s, "unknown paper 'a99'");
  refuses("g.txt --hidden curves" + s, "unknown hidden-surface method 'curves'");
  refuses("g.txt --lines edges" + s, "--lines: expected outline");
  refuses("g.txt -o s.svg --program no/s.draw", "no/s.draw: cannot be written");
  refuses("g.txt -o s.txt", "unknown picture format '.txt'");
  refuses("none.txt" + s, "none.txt: cannot be read");
  write("g.dat", "0 1 0\n1 2 1\n0 1 0\n");
  refuses("g.dat" + s, "g.dat: expected heights in a file .npy, .txt or .csv");
  refuses("g.txt --grid 5x5" + s, "--grid 5x5: expected an expression");
  refuses("-x*y" + s, "unknown option '-x*y': put an expression that begins with - in");
  write("far.txt", "0 1\n2 1e101\n");
  refuses("far.txt" + s,
          "height 1e+101 of point 2 2 of the surface: expected finite numbers of magnitude");
  refuses("none.npy" + s, "none.npy: no such file");
  refuses("g.txt g.txt --hidden perimeter" + s, "there are 2");
  write("g.txt", "1 2 3\n4 5\n");
  refuses("g.txt" + s, "g.txt:2:1: a row of 2 heights: expected 3, as in the first");
  write("g.txt", "1 2 3\n4 inf 5\n");
  refuses("g.txt" + s, "g.txt:2:3: 'inf': expected a finite number, or nan for a hole");
  write("g.txt", "1 2 3\n4 five 5\n");
  refuses("g.txt" + s, "g.txt:2:3: 'five': expected");
  write("g.txt", "1 2 3\n");
  refuses("g.txt" + s, "g.txt: surface of 3 x 1 points: expected 2 or more each way");
  write("g.txt", "1\n2\n");
  refuses("g.txt" + s, "g.txt: surface of 1 x 2 points: expected 2 or more each way");
  write("g.txt", "5\n");
  refuses("g.txt" + s, "g.txt: surface of 1 x 1 points: expected 2 or more each way");
  write("g.txt", "1 2\n3 \x1b[31m\n");
  refuses("g.txt" + s, "g.txt:2:3: '?[31m': expected a finite number");
  write("g.txt", "1 2\n3 " + std::string(100000, 'x') + "\n");
  refuses("g.txt" + s, "g.txt:2:3: '" + std::string(40, 'x') + "...': expected a finite number");
  write("g.txt", std::string("1 2\n3 4\0", 8));
  refuses("g.txt" + s, "g.txt:2:4: binary data: expected text");
  fs::create_directory(folder_ / "folder.txt");
  refuses("folder.txt" + s, "folder.txt: cannot be read: Is a directory");
  ASSERT_EQ(mkfifo((folder_ / "pipe.txt").c_str(), 0600), 0);
  refuses("pipe.txt" + s, "pipe.txt: not a regular file: expected one");
  fs::create_symlink("/dev/zero", folder_ / "zero.txt");
  refuses("zero.txt" + s, "zero.txt:1:1: binary data: expected text");
  write("g.txt", "");
  refuses("g.txt" + s, "g.txt: surface of 0 x 0 points");
  write("g.txt", "nan nan\nnan nan\n");
  refuses("g.txt" + s, "g.txt: there is no height at any point");
  const std::vector<double> heights{0, 1, 2, std::numeric_limits<double>::infinity()};
  displayfile::write_npy(heights, 2, 2, folder_ / "g.npy");
  refuses("g.npy" + s, "g.npy: height inf of point 2 2 of the surface");
}

TEST_F(SurfaceCommandTest, CommasAndComparisonsAreInExpressions) {
  if (!reads_expressions()) GTEST_SKIP() << "no muParser";
  ASSERT_EQ(run("surface 'x>=0 && y<=1 && x!=y || x==y ? max(x,y) : 7' -o s.svg --grid 3x2 "
                "--program s.draw"),
            0)
      << err_;
  // True where x is not negative, or x and y are both -1; x is -1, 0 or 1, y is -1 or 1.
  EXPECT_NE(read(folder_ / "s.draw").find("surface-3 -1 1 3 -1 1 2 -1 0 1 7 1 1\n"),
            std::string::npos)
      << read(folder_ / "s.draw");
}

TEST_F(SurfaceCommandTest, AnExpressionMayBeLongerThanAFilesName) {
  if (!reads_expressions()) GTEST_SKIP() << "no muParser";
  std::string sum = "x";
  for (int i = 0; i < 300; ++i) sum += "+y";
  ASSERT_EQ(run("surface '" + sum + "' --grid 3x3 -o long.svg"), 0) << err_;
  EXPECT_EQ(err_, "");
  ASSERT_EQ(run("surface 'x+300*y' --grid 3x3 -o short.svg"), 0) << err_;
  EXPECT_EQ(read(folder_ / "long.svg"), read(folder_ / "short.svg"));
}

TEST_F(SurfaceCommandTest, AnExpressionThatIsNoneIsToldWithItsPlace) {
  if (!reads_expressions()) GTEST_SKIP() << "no muParser";
  refuses("'sin(x' -o s.svg", "expression 'sin(x': at character 6: Missing parenthesis");
  refuses("'x^2+' -o s.svg", "expression 'x^2+': at character 5: Unexpected end");
  refuses("'x+q' -o s.svg", "expression 'x+q': at character 3");
  refuses("'x**2' -o s.svg", "expected an expression in x and y, with ^ for powers");
  refuses("'' -o s.svg", "SURFACE: is empty: expected EXPRESSION|HEIGHTS");
  refuses("- -o s.svg", "-: expected an expression in x and y, or heights in a file");
  refuses("'0,5*x' -o s.svg",
          "expression '0,5*x': 2 expressions with commas between them: expected");
  refuses("'x=5' -o s.svg", "expression 'x=5': at character 2: an assignment: expected");
  refuses("'x==1 ? y=2 : x' -o s.svg", "at character 9: an assignment");
  refuses("'1/x' --x 0:1 -o s.svg", "1/x: height inf of point 1 1 of the surface");
  refuses("x --grid 2000000000x2000000000 -o s.svg",
          "out of memory: x: drawing 4000000000000000000 points needs");
}

/// Numbers of many letters, and a long name, are not cut off at the picture's side.
TEST_F(SurfaceCommandTest, TheLegendHasRoomForItsTexts) {
  const std::string name = "temperature in K";
  for (const char* heights : {"1013250+50*x", "0.00012+0.00001*x*y", "(-101325.5)+0.5*x", "x"}) {
    ASSERT_EQ(run(fmt::format("surface '{}' --colour height -o s.svg --size 640x640 "
                              "--labels 'x,y,{}'",
                              heights, name)),
              0)
        << err_;
    std::istringstream lines(read(folder_ / "s.svg"));
    const std::regex text(" x=\"([^\"]+)\"[^>]*>([^<]*)<");
    int texts = 0;
    bool of_legend = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("<g id=")) of_legend = line.starts_with("<g id=\"segment-2-");
      std::smatch found;
      if (!line.starts_with("<text") || !of_legend || !std::regex_search(line, found, text))
        continue;
      ++texts;
      const auto letters = std::ranges::count_if(
          found[2].str(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
      EXPECT_LT(std::stod(found[1]) + 0.6 * 16.64 * static_cast<double>(letters), 640.0) << line;
    }
    EXPECT_GT(texts, 3) << heights;
  }
}

TEST_F(SurfaceCommandTest, LinesHaveNoColoursOfHeights) {
  expect_error("surface x --colour height --hidden franklin -o s.svg", "franklin draws lines only");
}

TEST_F(SurfaceCommandTest, WhatTouchesIsSetInTheProgramToo) {
  ASSERT_EQ(run("surface 'x^2 - 2*y' --x 0:2 --y -1:1 --grid 3x2 -o s.svg --program s.draw "
                "--touching 0.25"),
            0)
      << err_;
  EXPECT_NE(read(folder_ / "s.draw").find("set-touching 0.25\n"), std::string::npos);
  expect_error("surface x -o t.svg --touching on", "--touching");
}

}  // namespace
