// Widths and styles of kinds of lines by the command's --lines.

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/command_fixture.h"

namespace {

class LineStylesCommand : public Command {
 protected:
  void SetUp() override {
    Command::SetUp();
    write("box.draw",
          "set-perspective 3 2 6\nset-hidden-method franklin\nset-hidden-line-removal on\n"
          "set-back-face-removal off\nset-line-kind-style crease 7\n"
          "set-lines all\nset-line-style solid 0 0 0 1\nopen-segment 1\n"
          "box-3 -0.5 0.5 -0.5 0.5 -0.5 0.5\nclose-segment\n");
  }
  /// The line styles of a dump with that option, in order.
  std::vector<std::string> styles(const std::string& lines) {
    EXPECT_EQ(run("dump box.draw --lines '" + lines + "'"), 0) << err_;
    std::vector<std::string> found;
    std::istringstream all(out_);
    for (std::string line; std::getline(all, line);) {
      if (line.starts_with("line-style ")) found.push_back(line.substr(11));
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
  std::string error_of(const std::string& options) {
    EXPECT_EQ(run("draw box.draw -o box.svg " + options), 2) << options;
    EXPECT_EQ(std::ranges::count(err_, '\n'), 1) << err_;
    return err_;
  }
};

using Styles = std::vector<std::string>;

TEST_F(LineStylesCommand, SetWidthsDashesAndColours) {
  EXPECT_EQ(styles("outline,crease"), (Styles{"solid 0 0 0 1", "solid 0 0 0 7"}));
  EXPECT_EQ(styles("outline=0.5,crease=0.25,intersection=0.3"),
            (Styles{"solid 0 0 0 0.25", "solid 0 0 0 0.5"}));
  EXPECT_EQ(styles("outline=3,crease=0.25,hidden=0.125"),
            (Styles{"dashed 0 0 0 0.125 6 4", "solid 0 0 0 0.25", "solid 0 0 0 3"}));
  EXPECT_EQ(styles("outline=3px,crease=0.25,hidden=0.125 dashed 2 1 #ff0000"),
            (Styles{"dashed 1 0 0 0.125 2 1", "solid 0 0 0 0.25", "solid 0 0 0 3"}));
  EXPECT_EQ(styles("outline=#00ff00,crease=40,hidden=solid"),
            (Styles{"solid 0 0 0 3.5", "solid 0 0 0 7", "solid 0 1 0 1"}));
}

TEST_F(LineStylesCommand, AngleAndWidthOfACreaseAreToldApart) {
  EXPECT_EQ(styles("crease=100,outline=1"), (Styles{"solid 0 0 0 1"}));
  EXPECT_EQ(styles("crease=4.5deg"), (Styles{"solid 0 0 0 7"}));
  EXPECT_EQ(styles("crease=0"), (Styles{"solid 0 0 0 7"}));
  EXPECT_EQ(styles("crease=4.5"), (Styles{"solid 0 0 0 4.5"}));
  EXPECT_EQ(styles("crease=5"), (Styles{"solid 0 0 0 7"}));
  EXPECT_EQ(styles("crease=9px"), (Styles{"solid 0 0 0 9"}));
  EXPECT_EQ(styles("crease=100,crease=2,outline=1"), (Styles{"solid 0 0 0 1"}));
}

TEST_F(LineStylesCommand, HiddenDrawsHiddenLines) {
  EXPECT_EQ(styles("all,hidden"), (Styles{"dashed 0 0 0 0.5 6 4", "solid 0 0 0 1"}));
  EXPECT_EQ(styles("hidden=3"), (Styles{"dashed 0 0 0 3 18 12", "solid 0 0 0 1"}));
  EXPECT_NE(error_of("--lines hidden --hidden-lines none").find("--hidden-lines none"),
            std::string::npos)
      << err_;
}

TEST_F(LineStylesCommand, LengthsOnPaperAreMillimetres) {
  // 1.5 mm a pixel.
  ASSERT_EQ(run("draw box.draw -o box.svg --size 100x100 --paper 170x190 --lines "
                "outline=0.75,crease=3px,hidden=1.5mm"),
            0)
      << err_;
  const std::string svg = read(folder_ / "box.svg");
  for (const char* const width : {"0.5", "3", "1"}) {
    EXPECT_NE(svg.find(std::string("stroke-width:") + width), std::string::npos) << width << svg;
  }
  ASSERT_EQ(run("draw box.draw -o pens.svg --pens --lines outline=0.7,crease=0.25,hidden=0.18"), 0)
      << err_;
  const std::string pens = read(folder_ / "pens.svg");
  for (const char* const width : {"\"0.7\"", "\"0.25\"", "\"0.18\""}) {
    EXPECT_NE(pens.find(std::string("stroke-width=") + width), std::string::npos) << width;
  }
}

TEST_F(LineStylesCommand, LineWidthIsOfAllOtherLines) {
  const auto widths = [&](const std::string& options) {
    EXPECT_EQ(run("draw box.draw -o box.svg --size 100x100 " + options), 0) << err_;
    Styles found;
    const std::string svg = read(folder_ / "box.svg"), before = "{stroke:#000000;stroke-width:";
    for (std::size_t at = svg.find(before); at != svg.npos; at = svg.find(before, at + 1)) {
      const std::size_t begin = at + before.size();
      found.push_back(svg.substr(begin, svg.find_first_of(";}", begin) - begin));
    }
    return found;
  };
  EXPECT_EQ(widths("--line-width 3"), (Styles{"3"}));
  EXPECT_EQ(widths("--line-width 3px --paper 170x190"), (Styles{"3"}));
  EXPECT_EQ(widths("--line-width 3 --paper 170x190"), (Styles{"2"}));  // 1.5 mm a pixel
  EXPECT_EQ(widths("--line-width 2.25mm --paper 170x190 --lines all=0.75"), (Styles{"0.5"}));
  const Styles of_points = widths("--line-width 18pt --paper 170x190");  // 6.35 mm
  ASSERT_EQ(of_points.size(), 1u);
  EXPECT_NEAR(std::stod(of_points.front()), 6.35 / 1.5, 1e-3);
  EXPECT_EQ(widths("--line-width 2 --lines outline,crease"), (Styles{"2", "7"}));
  for (const char* const bad : {"wide", "1in", "0", "-1", "1e7", "1mm"}) {
    const std::string option = std::string("--line-width ") + bad;
    EXPECT_NE(error_of(option).find(option + ": "), std::string::npos) << err_;
  }
}

TEST_F(LineStylesCommand, WrongValuesAreRefusedByName) {
  for (const char* const bad :
       {"outline=", "outline=1x", "outline=1,crease=1;", "outline=1 2", "outline=1 dashed 3",
        "outline=1 dotted", "hidden=wide", "outline=1 dashed 1 2 3", "outline=1 #12"}) {
    EXPECT_NE(error_of(std::string("--lines '") + bad + "'").find("expected KIND=WIDTH"),
              std::string::npos)
        << err_;
  }
  EXPECT_NE(error_of("--lines outline=0").find("--lines outline=0: expected lengths above 0"),
            std::string::npos)
      << err_;
  EXPECT_NE(error_of("--lines outline=-1").find("expected lengths above 0"), std::string::npos);
  EXPECT_NE(error_of("--lines creese=1").find("did you mean 'crease'?"), std::string::npos) << err_;
  EXPECT_NE(error_of("--lines crease=181").find("from 0 to 180"), std::string::npos) << err_;
  EXPECT_NE(error_of("--lines ''").find("--lines"), std::string::npos) << err_;
  EXPECT_NE(error_of("--lines outline=1,").find("--lines"), std::string::npos) << err_;
  EXPECT_EQ(run("draw box.draw -o box.ppm --lines outline=1mm"), 2);
  EXPECT_NE(err_.find("expected --paper, --size in mm, --dpi with .png, or pixels"),
            std::string::npos)
      << err_;
  EXPECT_EQ(run("check box.draw --golden . --lines outline=1"), 2);
  EXPECT_NE(err_.find("options of draw and dump"), std::string::npos) << err_;
}

}  // namespace
