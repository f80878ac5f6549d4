#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/files.h"
#include "displayfile/text/dump_compare.h"
#include "tests/error_of.h"
#include "tests/replayed.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

using test::dump_of;

// ---- The format ---------------------------------------------------------------------------

/// The whole canonical format, as users' golden files hold it.
TEST(Dump, CanonicalFormat) {
  EXPECT_EQ(dump_of("set-window 0 1 0 1\n"
                    "open-segment 3\n"
                    "polygon-abs-3 .25 .25 0  .75 .25 0  .75 .75 .5\n"
                    "set-line-style dashed 1 0 .5 2\n"
                    "polygon-abs-3 .5 .5 0  1.5 .5 0  1.5 .75 0  .5 .75 0\n"  // cut at x = 1
                    "set-fill-style hollow\n"
                    "set-line-style none\n"
                    "set-pick-id 7\n"
                    "polygon-abs-2 0 0 .5 0 .5 .5\n"
                    "close-segment\n"
                    "open-segment 1\n"
                    "set-line-style solid 0 0 1\n"
                    "move-abs-3 .1 .2 0\n"
                    "line-abs-3 .3 .4 0\n"
                    "line-abs-3 .5 .6 0\n"
                    "close-segment\n"
                    "set-visibility 1 off\n"
                    "open-segment 2\n"
                    "close-segment\n"),
            "displayfile-dump 1\n"
            "segment 3 visible\n"
            "fill solid 0.8 0.8 0.8\n"
            "line-style solid 0 0 0 1\n"
            "pick 0\n"
            "polygon 3 0.75 0.75 0.875\n"
            "line 0.25 0.25 0.75\n"
            "line 0.75 0.25 0.75\n"
            "line 0.75 0.75 0.875\n"
            "line-style dashed 1 0 0.5 2 6 4\n"
            "pick 1\n"
            "polygon 4 0.5 0.75 0.75\n"
            "line 0.5 0.5 0.75\n"
            "line 1 0.5 0.75\n"
            "move 1 0.75 0.75\n"
            "line 0.5 0.75 0.75\n"
            "fill hollow\n"
            "line-style none\n"
            "pick 7\n"
            "polygon 3 0.5 0.5 0.75\n"
            "line 0 0 0.75\n"
            "line 0.5 0 0.75\n"
            "line 0.5 0.5 0.75\n"
            "segment 1 invisible\n"
            "line-style solid 0 0 1 1\n"
            "move 0.1 0.2 0.75\n"
            "line 0.3 0.4 0.75\n"
            "line 0.5 0.6 0.75\n"
            "segment 2 visible\n"
            "end\n");
  EXPECT_EQ(dump_of(""), "displayfile-dump 1\nend\n");
}

/// Points are those that are drawn: after the image transformation.
TEST(Dump, PointsAreDrawnOnes) {
  EXPECT_EQ(dump_of("set-window 0 1 0 1\n"
                    "open-segment 1\nset-line-style solid 0 0 0\nline-abs-3 .5 .25 1\n"
                    "close-segment\n"
                    "set-image-scale 1 2 2\nset-image-rotation 1 90\n"
                    "set-image-translation 1 1 .125\n"),
            "displayfile-dump 1\n"
            "segment 1 visible\n"
            "line-style solid 0 0 0 1\n"
            "move 1 0.125 0.75\n"
            "line 0.5 1.125 1\n"
            "end\n");
}

TEST(Dump, NumbersReadBackToTheSameDouble) {
  DisplayFile display_file;
  Segment& segment = display_file.create(1);
  segment.enter_line({0.1 + 0.2, -0.0, 1.0 / 3.0}, {5e-324, 1e-7, 1e300});
  EXPECT_EQ(dump(display_file),
            "displayfile-dump 1\nsegment 1 visible\n"
            "move 0.30000000000000004 -0 0.3333333333333333\n"
            "line 5e-324 1e-07 1e+300\nend\n");
}

// ---- Differences --------------------------------------------------------------------------

std::string dump_with(const std::string& lines) { return "displayfile-dump 1\n" + lines + "end\n"; }

TEST(DumpDifference, NoneBetweenEqualDumps) {
  const std::string text = dump_with("segment 1 visible\npick 0\nsegment 2 invisible\n");
  EXPECT_EQ(first_difference(text, text), std::nullopt);
  EXPECT_EQ(first_difference(dump_with(""), dump_with("")), std::nullopt);
}

TEST(DumpDifference, NamesSegmentInstructionAndBothValues) {
  struct Case {
    std::string actual, expected, message;
  };
  const std::string start =
      "segment 7 visible\npick 0\nsegment 3 visible\nfill solid 1 0 0\nline-style solid 0 0 0 1\n";
  const Case cases[] = {
      {"line 0.1 0.25 0\n", "line 0.1 0.5 0\n",
       "segment 3, instruction 3 (line 0.1 0.25 0): y is 0.25, expected 0.5"},
      {"move 0 0 -0\n", "move 0 0 0\n",
       "segment 3, instruction 3 (move 0 0 -0): z is -0, expected 0"},
      {"polygon 3 0.5 0 0\n", "polygon 4 0.5 0 0\n",
       "segment 3, instruction 3 (polygon 3 0.5 0 0): number of sides is 3, expected 4"},
      {"polygon 3 0.5 0 0\n", "polygon 3 0.5 1 0\n",
       "segment 3, instruction 3 (polygon 3 0.5 0 0): y is 0, expected 1"},
      {"pick 4\n", "pick 5\n",
       "segment 3, instruction 3 (pick 4): pick identifier is 4, expected 5"},
      {"fill solid 1 0 0\n", "fill solid 1 0 0.5\n",
       "segment 3, instruction 3 (fill solid 1 0 0): blue is 0, expected 0.5"},
      {"line-style dashed 0 0 0 1 2 3\n", "line-style dashed 0 0 0 1 2 4\n",
       "segment 3, instruction 3 (line-style dashed 0 0 0 1 2 3): gap is 3, expected 4"},
      {"line-style solid 0 0 0 2\n", "line-style solid 0 0 0 1\n",
       "segment 3, instruction 3 (line-style solid 0 0 0 2): line width is 2, expected 1"},
      {"fill hollow\n", "fill solid 0 0 0\n",
       "segment 3, instruction 3 is fill hollow, expected fill solid 0 0 0"},
      {"line 0 0 0\n", "move 0 0 0\n",
       "segment 3, instruction 3 is line 0 0 0, expected move 0 0 0"},
      {"line 0 0 0\n", "line 0 0 0\nline 1 1 1\n",
       "segment 3, instruction 4 is missing, expected line 1 1 1"},
      {"segment 9 visible\n", "line 1 1 1\nsegment 9 visible\n",
       "segment 3, instruction 3 is missing, expected line 1 1 1"},
      {"line 1 1 1\n", "",
       "segment 3, instruction 3 (line 1 1 1) is not expected: expected 2 instructions"},
      {"segment 5 visible\n", "segment 5 invisible\n", "segment 5 is visible, expected invisible"},
      {"segment 5 visible\n", "", "segment 5 is not expected"},
      {"", "segment 5 visible\n", "segment 5 is missing"},
      {"segment 5 visible\nsegment 6 visible\n", "segment 6 visible\n",
       "segment 5 is not expected"},
      {"segment 6 visible\n", "segment 5 visible\nsegment 6 visible\n", "segment 5 is missing"},
      {"segment 5 visible\n", "segment 6 visible\n", "segment 5 in the place of segment 6"},
      {"segment 5 visible\nsegment 6 visible\n", "segment 6 visible\nsegment 5 visible\n",
       "segment 5 in the place of segment 6"},
  };
  for (const auto& [actual, expected, message] : cases) {
    EXPECT_EQ(first_difference(dump_with(start + actual), dump_with(start + expected)), message);
  }
}

std::string error_of_difference(const std::string& actual, const std::string& expected) {
  return test::error_of([&] { first_difference(actual, expected); });
}

TEST(DumpDifference, TextsThatAreNoDumpsAreErrors) {
  const std::string good = dump_with("segment 1 visible\n");
  EXPECT_EQ(
      error_of_difference("", good),
      "the dump:1:1: not a display-file dump: expected 'displayfile-dump 1' in the first line");
  EXPECT_NE(error_of_difference(good, "displayfile-dump 2\nend\n"), "");
  EXPECT_NE(error_of_difference("P6 1 1 255\n", "P6 1 1 255\n"), "");
  EXPECT_EQ(error_of_difference(good, "displayfile-dump 1\nsegment 1 visible\n"),
            "the expected dump:3:1: the dump is cut short: expected 'end' in the last line");
}

// ---- Golden files -------------------------------------------------------------------------

class GoldenFile : public test::TemporaryFolder {
 protected:
  void SetUp() override {
    golden_ = file("scene.txt").string();
    replay("open-segment 1\npolygon-abs-2 0 0 .5 0 .5 .5\nclose-segment\n", "scene", system_);
  }

  std::string content() const { return test::content(golden_); }
  void write(const std::string& text) const { file("scene.txt", text); }
  std::optional<std::string> difference() const {
    return first_difference(dump(system_.display_file()), read_text_file(golden_), "the dump",
                            golden_);
  }
  std::string check_error() const {
    try {
      difference();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  std::string golden_;
  GraphicsSystem system_;
};

TEST_F(GoldenFile, HoldsAfterAnUpdate) {
  update_golden(system_.display_file(), golden_);
  EXPECT_EQ(content(), dump(system_.display_file()));
  EXPECT_EQ(difference(), std::nullopt);
}

TEST_F(GoldenFile, TellsTheFirstDifference) {
  update_golden(system_.display_file(), golden_);
  system_.set_image_translation(1, 0, 0.25);
  EXPECT_EQ(difference(),
            "segment 1, instruction 4 (polygon 3 0.75 1 0.75): y is 1, expected 0.75");
}

TEST_F(GoldenFile, MissingCutShortOrBinaryIsAnError) {
  EXPECT_EQ(check_error(), golden_ + ": cannot be read: No such file or directory");
  const std::string whole = dump(system_.display_file());
  write(whole.substr(0, whole.size() / 2));
  EXPECT_NE(check_error().find("scene.txt:"), std::string::npos);
  EXPECT_NE(check_error().find("cut short"), std::string::npos);
  write(std::string("\x89PNG\r\n\x1a\n\0\0", 10));
  EXPECT_EQ(check_error(), golden_ +
                               ":1:1: not a display-file dump: expected 'displayfile-dump "
                               "1' in the first line");
}

TEST_F(GoldenFile, UpdateInAMissingFolderIsAnErrorAndLeavesNothing) {
  const std::string path = (folder_ / "missing" / "scene.txt").string();
  EXPECT_THROW(update_golden(system_.display_file(), path), Error);
  EXPECT_TRUE(empty_folder());
}

}  // namespace
}  // namespace displayfile
