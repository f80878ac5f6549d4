// Texts in vector files.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>

#include "interp/draw/draw.h"
#include "tests/replayed.h"
#include "tests/temporary_folder.h"
#include "tests/text_scenes.h"
#include "tests/without_keys.h"

namespace displayfile {
namespace {

using namespace test;

class TextFile : public TemporaryFolder {
 protected:
  std::string drawn(std::string_view program, const std::string& name,
                    const DrawOptions& options = {}) {
    draw(replayed(program), file(name), options);
    return content(file(name));
  }
};

TEST_F(TextFile, SvgHasTextElementsAfterAllElse) {
  const std::string svg =
      test::without_keys(drawn(scene_with("move-abs-3 .5 .25 0\nset-text-style .05 centre\n"
                                          "text \"x < y & \\\"z\\\" > \u03c0\"\n"
                                          "move-abs-3 .5 .5 -1\ntext \"hidden\"\n"
                                          "set-text-style .05 centre always\ntext \" always\"\n"
                                          "set-line-style solid 1 0 0\n"
                                          "set-text-style .03 right\n"
                                          "move-abs-3 .875 .875 0\ntext \"corner\"\n"
                                          "polygon-abs-3 0 0 1  .1 0 1  .1 .1 1\n"),
                               "a.svg"));
  EXPECT_NE(
      svg.find("</g>\n"
               "<g id=\"segment-1-3\" class=\"segment\">\n"
               "<text class=\"t1\" x=\"256\" y=\"384\">x &lt; y &amp; \"z\" &gt; "
               "\u03c0</text>\n"
               "<text class=\"t1\" xml:space=\"preserve\" x=\"256\" y=\"256\"> always</text>\n"
               "<text class=\"t2\" x=\"448\" y=\"64\">corner</text>\n"
               "</g>\n</svg>\n"),
      svg.npos)
      << svg;
  EXPECT_NE(
      svg.find(".t1{fill:#0033ff;font-family:sans-serif;font-size:25.6px;text-anchor:middle}\n"
               ".t2{fill:#ff0000;font-family:sans-serif;font-size:15.36px;text-anchor:end}\n"),
      svg.npos)
      << svg;
  EXPECT_EQ(svg.find("hidden"), svg.npos);
}

TEST_F(TextFile, SvgByEveryMethodHidesTheSame) {
  for (const HiddenMethod method : methods_that_remove()) {
    DrawOptions options;
    options.surfaces.method = method;
    const std::string svg = drawn(scene_with("move-abs-3 .5 .25 -1\ntext \"behind\"\n"
                                             "move-abs-3 .125 .25 0\ntext \"side\"\n"),
                                  "a.svg", options);
    EXPECT_EQ(svg.find("behind"), svg.npos) << name_of(method);
    EXPECT_NE(svg.find("side"), svg.npos) << name_of(method);
  }
  // The choice of auto must not depend on whether polygons hide each other.
  EXPECT_EQ(drawn("set-hidden-line-removal on\nset-line-style none\nopen-segment 1\n"
                  "polygon-abs-2 0 0 1 0 1 1\nmove-abs-3 .7 .3 -1\ntext \"behind\"\n"
                  "close-segment\n",
                  "a.svg")
                .find("behind"),
            std::string::npos);
  DrawOptions none;
  none.surfaces.method = HiddenMethod::none;
  EXPECT_NE(
      drawn(scene_with("move-abs-3 .5 .25 -1\ntext \"behind\"\n"), "a.svg", none).find("behind"),
      std::string::npos);
}

/// Without a text, a file has nothing about texts.
TEST_F(TextFile, SvgWithoutTextIsAsItWas) {
  EXPECT_EQ(drawn(scene_with(""), "a.svg").find("text"), std::string::npos);
}

/// As somebody else reads the PDF.
TEST_F(TextFile, PdfHoldsTheCharacters) {
  if (std::system("command -v pdftotext > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "pdftotext is not installed";
  }
  drawn(scene_with("move-abs-3 .5 .25 0\nset-text-style .05 centre\ntext \"caf\u00e9 (1)\"\n"
                   "move-abs-3 .5 .5 -1\ntext \"hidden\"\n"),
        "a.pdf");
  const std::string out = file("a.txt").string();
  ASSERT_EQ(std::system(fmt::format("pdftotext '{}' '{}'", file("a.pdf").string(), out).c_str()),
            0);
  const std::string text = content(out);
  EXPECT_NE(text.find("caf\u00e9 (1)"), text.npos) << text;
  EXPECT_EQ(text.find("hidden"), text.npos) << text;
}

}  // namespace
}  // namespace displayfile
