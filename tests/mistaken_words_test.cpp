// Words on the command line that stand where they have no meaning, and help.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>

#include "tests/command_fixture.h"

namespace {

/// The command alone, and `help`, print the text of --help.
TEST_F(Command, HelpInOtherWords) {
  ASSERT_EQ(run("--help"), 0);
  const std::string help = out_;
  EXPECT_EQ(run(""), 2);
  EXPECT_EQ(err_, help);
  EXPECT_EQ(out_, "");
  EXPECT_EQ(run("help"), 0) << err_;
  EXPECT_EQ(out_, help);
  EXPECT_NE(help.find("displayfile help COMMAND"), std::string::npos) << help;
  ASSERT_EQ(run("draw --help"), 0);
  const std::string of_draw = out_;
  EXPECT_EQ(run("help draw"), 0) << err_;
  EXPECT_EQ(out_, of_draw);
  const std::string in_a_line = std::regex_replace(of_draw, std::regex("\\s+"), " ");
  EXPECT_NE(in_a_line.find("together [all with --hidden and"), std::string::npos)
      << "the default scope";
  expect_error("help drew", "unknown command 'drew': did you mean 'draw'?");
  expect_error("help draw dump", "help: expected one command, such as displayfile help draw");
}

TEST_F(Command, HelpIsInLinesThatFit) {
  for (const char* const command : {"", "draw", "surface", "sheet", "check", "bench"}) {
    ASSERT_EQ(run(std::string(command) + " --help"), 0) << err_;
    std::istringstream lines(out_);
    for (std::string line; std::getline(lines, line);) {
      const bool is_name = line.starts_with("  -") || line.starts_with("Usage");
      EXPECT_TRUE(line.size() <= 100 || is_name) << line;
      EXPECT_EQ(line.find("INT in ["), line.npos) << line;
      EXPECT_EQ(line.find("REQUIRED"), line.npos) << line;
    }
  }
  ASSERT_EQ(run("draw --help"), 0);
  EXPECT_NE(out_.find("  --samples N "), std::string::npos) << out_;
  EXPECT_NE(out_.find("; 1 to 16; 4 if not given"), std::string::npos) << out_;
}

/// A word that no option takes would be an input.
TEST_F(Command, SaysWhichOptionAWordWasMeantFor) {
  write("t.draw", kTriangle);
  expect_error("draw t.draw -o x.svg --pens 3",
               "--pens 3: --pens takes no value, and there is no file 3");
  expect_error("draw t.draw -o x.svg --lines outline crease",
               "--lines outline crease: there is no file crease: expected commas between values: "
               "--lines outline,crease");
  expect_error("draw --lines=outline crease t.draw -o x.svg", "--lines outline,crease");
  expect_error("draw --stats missing.obj -o x.svg", "missing.obj: no such file: expected a mesh");
  expect_error("draw -o x.svg -- --stats", "--stats: no such file: expected a mesh");
  expect_error("draw t.draw -o x.svg --paper A7", "unknown paper 'A7': expected A0 to A6, letter");
  expect_error("draw t.draw -o x.svg --paper lettre", "did you mean 'letter'? expected A0 to A6");
  write("3", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write("crease", read(folder_ / "t.draw"));
  EXPECT_EQ(run("draw --stats 3 -o x.svg --hidden map"), 0) << err_ << "which is a file";
}

TEST_F(Command, FoldersAndPatternsAreNoInputs) {
  fs::create_directory(folder_ / "parts");
  write("parts/t.draw", kTriangle);
  for (const char* command : {"draw parts -o x.svg", "dump parts", "truth parts --ids i.npy",
                              "steps parts --hidden bsp -o x.html", "check parts --golden g",
                              "check parts --golden g --update"}) {
    expect_error(command,
                 "parts: is a folder: expected drawing programs or meshes, such as parts/*.draw");
  }
  for (const char* command : {"draw 'parts/*.obj' -o x.svg", "check 'parts/*.obj' --golden g"}) {
    expect_error(command,
                 "parts/*.obj: no such file, and no shell has expanded the pattern: expected it "
                 "without quotation marks");
  }
  write("[1].draw", kTriangle);
  EXPECT_EQ(run("draw '[1].draw' -o x.svg"), 0) << err_;
}

TEST_F(Command, OutputsAndInputsOfOtherCommandsAreRefused) {
  write("t.draw", kTriangle);
  for (const char* name : {"a.svg", "a.PNG", "a.ppm", "a.pdf", "a.eps"}) {
    expect_error(std::string("dump t.draw -o ") + name,
                 std::string(name) +
                     ": dump writes text: expected a name that ends in .txt; "
                     "displayfile draw writes pictures");
  }
  EXPECT_EQ(run("draw t.draw -o a.svg"), 0) << err_;
  for (const char* names : {"a.svg b.svg", "a.svg a.svg", "t.draw a.svg"}) {
    expect_error(std::string("compare ") + names,
                 "a.svg: vectors are not compared: expected a picture of pixels, a .npy file or a "
                 "dump");
  }
}

TEST_F(Command, CompareNamesTheFirstFileThatIsWrong) {
  expect_error("compare no1.txt no2.txt", "displayfile: no1.txt: cannot be read");
  expect_error("compare no1.png no2.png", "displayfile: no1.png: no such file");
  for (const char* name : {"a.svg", "a.pdf", "a.eps"}) {
    write(name, "");
    const std::string message = std::string(name) + ": vectors are not compared: expected";
    expect_error(fmt::format("compare {} {}", name, name), message);
  }
}

}  // namespace
