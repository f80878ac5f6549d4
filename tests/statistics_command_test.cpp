// The counts of `displayfile draw --stats`.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "tests/command_fixture.h"

namespace {

TEST_F(Command, StatisticsCountWhatTouches) {
  const std::string rug =
      "rotate-x-3 33.3\nrotate-y-3 21.7\nset-line-style none\nopen-segment 1\n"
      "polygon-abs-3 -0.8 -0.8 0.1  0.8 -0.8 0.1  0.8 0.8 0.1  -0.8 0.8 0.1\n"
      "polygon-abs-3 -0.7 -0.61 0.1  0.63 -0.6 0.1  0.67 0.7 0.1\n"
      "polygon-abs-3 -0.7 -0.61 0.5  0.63 -0.6 0.5  0.67 0.7 0.5\nclose-segment\n";
  write("rug.draw", rug);
  ASSERT_EQ(run("draw rug.draw -o rug.ppm --stats"), 0) << err_;
  EXPECT_NE((out_ + err_).find("touching           2 polygons, in 1 plane\n"), std::string::npos)
      << out_ << err_;
  ASSERT_EQ(run("draw rug.draw -o rug.ppm --stats --touching off"), 0) << err_;
  EXPECT_NE((out_ + err_).find("touching           2 polygons, in 1 plane\n"), std::string::npos)
      << out_ << err_;
}

TEST_F(Command, StatisticsHaveTimes) {
  write("t.draw", kTriangle);
  const std::regex times(
      "times              [0-9]+\\.[0-9]{3} s to read and enter, [0-9]+\\.[0-9]{3} s to draw and "
      "write\n");
  for (const char* options : {"-o a.png", "-o a.svg", "-o a.png --turntable 2"}) {
    ASSERT_EQ(run(std::string("draw t.draw --stats ") + options), 0) << err_;
    EXPECT_TRUE(std::regex_search(out_, times)) << options << "\n" << out_;
  }
}

/// A stack of sheets, entered from the farthest on: with the root entered last, or first, the tree
/// is a chain; the others are shallower.
TEST_F(Command, TheRootOfATreeCanBeSet) {
  constexpr int kSheets = 40;
  std::string sheets = "set-line-style none\nopen-segment 1\n";
  for (int k = 0; k < kSheets; ++k) {
    sheets += fmt::format("polygon-abs-3 0.1 0.1 {0}  0.9 0.1 {0}  0.5 0.9 {0}\n", -0.5 + 0.01 * k);
  }
  write("sheets.draw", sheets + "close-segment\n");
  std::string pictures[4];
  int depths[4], k = 0;
  for (const char* const root : {"last", "first", "sample", "free"}) {
    const std::string hidden = std::string(" --hidden bsp=") + root;
    ASSERT_EQ(run("draw sheets.draw -o a.ppm --size 20x20 --stats" + hidden), 0) << err_;
    const std::string counts = out_ + err_, words = "depth of the tree";
    const std::size_t at = counts.find(words);
    ASSERT_NE(at, std::string::npos) << counts;
    depths[k] = std::stoi(counts.substr(at + words.size()));
    pictures[k++] = read(folder_ / "a.ppm");
  }
  EXPECT_EQ(depths[0], kSheets);
  EXPECT_EQ(depths[1], kSheets);
  EXPECT_LT(depths[2], kSheets / 2);
  EXPECT_LT(depths[3], kSheets);
  for (const std::string& picture : pictures) EXPECT_EQ(picture, pictures[0]);
  expect_error("draw sheets.draw -o a.ppm --hidden bsp=middle",
               "root 'middle' of a BSP tree: expected last, first, sample or free");
}

}  // namespace
