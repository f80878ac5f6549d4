// `displayfile draw --check`: whether files are those that would be drawn now.

#include <filesystem>
#include <string>

#include "tests/command_fixture.h"

namespace {

class DrawCheck : public Command {
 protected:
  DrawCheck() {
    write("t.draw", kTriangle);
    write("u.draw", "open-segment 1\nset-fill-style solid 1 0 0\n" +
                        std::string("polygon-abs-3 0 0 0  1 0 0  1 1 0\nclose-segment\n"));
  }
  /// Draws, finds no difference, and finds one after the input has changed.
  void expect_found(const std::string& options, const std::string& file, const std::string& how) {
    SCOPED_TRACE(options);
    ASSERT_EQ(run("draw t.draw " + options), 0) << err_;
    const auto written = fs::last_write_time(folder_ / file);
    EXPECT_EQ(run("draw t.draw --check " + options), 0) << out_ << err_;
    EXPECT_EQ(out_, "");
    const std::string as_it_was = read(folder_ / "t.draw");
    write("t.draw", read(folder_ / "u.draw"));
    EXPECT_EQ(run("draw t.draw --check " + options), 1) << err_;
    EXPECT_NE(out_.find(file + ": differs: " + how), std::string::npos) << out_;
    write("t.draw", as_it_was);
    EXPECT_EQ(fs::last_write_time(folder_ / file), written) << "it was written";
  }
};

TEST_F(DrawCheck, EveryFormatAndEveryOption) {
  expect_found("-o a.svg", "a.svg", "line ");
  expect_found("-o a.pdf --paper a6 --line-width 0.5pt", "a.pdf", "byte ");
  expect_found("-o a.png --size 30x20mm --dpi 150", "a.png", "");
  expect_found("-o a.ppm --size 40x30 --samples 1", "a.ppm", "");
  expect_found("-o a.svg --pens --order cut", "a.svg", "line ");
  expect_found("-o b.png --size 40x30 --ids i.npy --depth d.npy", "i.npy", "");
  expect_found("-o b.png --size 40x30 --ids i.npy --depth d.npy", "d.npy", "");
  expect_found("-o turn.png --turntable 3 --size 40x30", "turn-001.png", "");
  expect_found("-o '{name}-x.svg' u.draw", "t-x.svg", "line ");
}

TEST_F(DrawCheck, FormatsAreThoseOfTheFilesNotOfTheirNames) {
  expect_found("-o a.png --format svg", "a.png", "line ");
  expect_found("-o a.svg --format png --size 40x30", "a.svg", "");
  ASSERT_EQ(run("draw t.draw -o a.png --size 40x30"), 0) << err_;
  EXPECT_EQ(run("draw t.draw -o a.png --format svg --check"), 1) << err_;
  EXPECT_EQ(out_, "a.png: differs: another format\n");
}

/// The pixels are the same, and larger on paper.
TEST_F(DrawCheck, TheDensityOfPngIsCompared) {
  ASSERT_EQ(run("draw t.draw -o a.png --size 40x30 --dpi 100"), 0) << err_;
  EXPECT_EQ(run("draw t.draw -o a.png --size 40x30 --dpi 100 --check"), 0) << out_ << err_;
  for (const char* other : {"--dpi 200", ""}) {
    EXPECT_EQ(run(std::string("draw t.draw -o a.png --size 40x30 --check ") + other), 1) << err_;
    EXPECT_EQ(out_, "a.png: differs: another dpi\n");
  }
}

TEST_F(DrawCheck, SaysWhatIsMissingAndLeavesNothing) {
  const auto files = [&] {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++count;
    return count;
  };
  ASSERT_EQ(run("--version"), 0);  // which leaves its output there
  const int before = files();
  EXPECT_EQ(run("draw t.draw -o none.svg --check"), 1) << err_;
  EXPECT_EQ(out_, "none.svg: differs: it is missing\n");
  EXPECT_EQ(run("draw t.draw u.draw -o '{name}.png' --check"), 1) << err_;
  EXPECT_EQ(out_, "t.png: differs: it is missing\nu.png: differs: it is missing\n");
  EXPECT_EQ(files(), before);
  ASSERT_EQ(run("draw t.draw -o a.png --size 40x30"), 0) << err_;
  EXPECT_EQ(run("draw t.draw -o a.png --size 41x30 --check"), 1) << err_;
  EXPECT_EQ(out_, "a.png: differs: another size\n");
  expect_error("draw t.draw -o - --check", "--check: standard output is no file to compare with");
  expect_error("draw t.draw -o a.gif --check", "unknown picture format '.gif'");
  before_ = "TMPDIR=" + folder_.string() + "/temporary ";
  fs::create_directory(folder_ / "temporary");
  EXPECT_EQ(run("draw t.draw -o a.png --size 40x30 --check"), 0) << err_;
  EXPECT_TRUE(fs::is_empty(folder_ / "temporary"));
  write("bad.draw", "open-segment 1\nfly\n");
  EXPECT_EQ(run("draw bad.draw t.draw -o '{name}.svg' --check"), 2);
  EXPECT_TRUE(fs::is_empty(folder_ / "temporary"));
}

}  // namespace
