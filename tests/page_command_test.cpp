// `displayfile page`: one file with all that it needs, whole or not at all, and refused arguments.
// The pages' behaviour is tested in a browser (programs/page/tests).

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/command_fixture.h"

namespace {

using Json = nlohmann::json;

class PageCommand : public Command {
 protected:
  void SetUp() override {
    write("triangle.draw", kTriangle);
    fs::create_directory(folder_ / "package");
    for (const std::string name : {"displayfile-module", "displayfile-viewer"}) {
      write("package/" + name + ".wasm.lzma.base64", "WQAA" + name);
      write("package/" + name + ".js", "var createDisplayfile;\n");
    }
    write("package/displayfile.js", "var displayfile;\n");
  }
  std::string page(const std::string& words) {
    EXPECT_EQ(run("page " + words + " --package package -o page.html"), 0) << err_;
    return read(folder_ / "page.html");
  }
  static Json data_of(const std::string& page) {
    const std::string before = R"(<script type="application/json" id="data">)";
    const std::size_t begin = page.find(before) + before.size();
    return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  }
};

TEST_F(PageCommand, HoldsTheSceneAndWhatDrawsIt) {
  const std::string text = page("triangle.draw --size 30x20 --hidden bsp");
  const Json data = data_of(text);
  EXPECT_EQ(data["width"], 30);
  EXPECT_EQ(data["height"], 20);
  EXPECT_EQ(data["method"], "bsp");
  EXPECT_EQ(data["wasm"], "WQAAdisplayfile-viewer");
  ASSERT_EQ(data["scenes"].size(), 1u);
  EXPECT_EQ(data["scenes"][0]["name"], "triangle.draw");
  EXPECT_NE(text.find("<title>triangle.draw</title>"), std::string::npos);
  EXPECT_NE(text.find("var createDisplayfile;"), std::string::npos);
  // The embedded program draws the command's picture.
  write("embedded.draw", data["scenes"][0]["program"]);
  EXPECT_EQ(run("draw embedded.draw -o embedded.svg --size 30x20 --hidden bsp"), 0) << err_;
  EXPECT_EQ(run("draw triangle.draw -o triangle.svg --size 30x20 --hidden bsp"), 0) << err_;
  const std::string svg = read(folder_ / "triangle.svg");
  EXPECT_EQ(read(folder_ / "embedded.svg"), svg);
  EXPECT_NE(text.find(svg.substr(svg.find("<svg"))), std::string::npos);  // the still
}

TEST_F(PageCommand, NothingIsAskedOfTheNetwork) {
  for (const char* words : {"triangle.draw", ""}) {
    const std::string text = page(words);
    for (const char* asked : {"<link rel=\"stylesheet\"", "<script src=", "@import", "url(http"}) {
      EXPECT_EQ(text.find(asked), std::string::npos) << words << ": " << asked;
    }
  }
}

TEST_F(PageCommand, NamesAndTitlesAreNoMarkup) {
  write("<script><b>.draw", kTriangle);
  const std::string text = page("'<script><b>.draw'");
  EXPECT_EQ(data_of(text)["scenes"][0]["name"], "<script><b>.draw");
  EXPECT_NE(text.find("<title>&lt;script>&lt;b>.draw</title>"), std::string::npos);
  EXPECT_NE(page("triangle.draw --title '</title>'").find("<title>&lt;/title></title>"),
            std::string::npos);
  EXPECT_NE(page("triangle.draw --title 'A & B'").find("<title>A &amp; B</title>"),
            std::string::npos);
  write("a\xff\x01.draw", kTriangle);
  EXPECT_NE(page("'a\xff\x01.draw'").find("<title>a??.draw</title>"), std::string::npos);
  expect_error("page triangle.draw --package package -o page.html --title '\x01'",
               "--title: character U+0001 in a text");
}

TEST_F(PageCommand, WithoutASceneItHasTheGallery) {
  const Json data = data_of(page(""));
  EXPECT_GE(data["scenes"].size(), 20u);
  EXPECT_EQ(data["scenes"][0]["name"], "concave-and-crossing.draw");
}

TEST_F(PageCommand, BadInputIsRefused) {
  expect_error("page triangle.draw --package nowhere -o page.html", "displayfile-viewer.wasm");
  expect_error("page triangle.draw --package nowhere -o page.html",
               "interp/web/make-package builds the WebAssembly of pages");
  expect_error("page missing.draw --package package -o page.html", "missing.draw");
  expect_error("page triangle.draw --package package --hidden fly -o page.html", "'fly'");
  expect_error("page triangle.draw --package package -o nowhere/page.html", "nowhere");
  write("package/displayfile.js", "const markup = '</script>';\n");
  expect_error("page triangle.draw --package package -o page.html",
               "displayfile.js cannot be part of a page");
}

}  // namespace
