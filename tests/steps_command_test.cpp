// `displayfile steps`: the page and its data, whole or not at all, and refused arguments.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/command_fixture.h"

namespace {

using Json = nlohmann::json;

class StepsCommand : public Command {
 protected:
  void SetUp() override { write("triangle.draw", kTriangle); }
  Json told(const std::string& words) {
    EXPECT_EQ(run("steps triangle.draw " + words + " -o steps.json"), 0) << err_;
    return Json::parse(read(folder_ / "steps.json"));
  }
};

TEST_F(StepsCommand, TellsWhatThePictureGains) {
  for (const char* method :
       {"bsp", "depth-sort", "z-buffer", "scan-line", "scan-line-z", "warnock", "ray-cast"}) {
    const Json all = told(std::string("--size 8x8 --hidden ") + method);
    EXPECT_EQ(all["method"], method);
    EXPECT_EQ(all["width"], 8);
    EXPECT_EQ(all["polygons"].size(), 1u);
    int pixels = 0;
    for (const Json& step : all["steps"]) {
      EXPECT_LT(step["line"].get<std::size_t>(), all["listing"].size());
      for (const Json& run : step.value("gained", Json::array())) {
        pixels += run[2].get<int>() - run[1].get<int>();
      }
    }
    EXPECT_EQ(pixels, 28) << method;  // the centres under the diagonal, which is a right edge
  }
}

TEST_F(StepsCommand, WritesAPageThatHoldsItsDataAndAsksForNoFile) {
  EXPECT_EQ(run("steps triangle.draw --hidden bsp --size 8x8 --title 'A < B' -o steps.html"), 0)
      << err_;
  const std::string page = read(folder_ / "steps.html");
  EXPECT_NE(page.find("<title>A &lt; B</title>"), page.npos);
  EXPECT_EQ(page.find("src="), page.npos);
  const std::string icon = R"(href="data:,")";  // none, which a browser would request from a server
  EXPECT_EQ(page.find("href="), page.find(icon));
  EXPECT_EQ(page.rfind("href="), page.find(icon));
  const std::string before = R"(<script type="application/json" id="data">)";
  const std::size_t begin = page.find(before) + before.size();
  const Json data = Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  EXPECT_EQ(data, told("--hidden bsp --size 8x8"));
}

TEST_F(StepsCommand, RefusesWhatTellsNoSteps) {
  expect_error("steps triangle.draw --hidden map -o a.html", "expected one of bsp depth-sort");
  expect_error("steps triangle.draw --hidden nothing -o a.html",
               "unknown hidden-surface method 'nothing': expected one of bsp depth-sort");
  expect_error("steps triangle.draw --hidden dept-sort -o a.html", "did you mean 'depth-sort'?");
  expect_error("steps triangle.draw --hidden mapp -o a.html", "'mapp': expected one of bsp");
  expect_error("steps triangle.draw --hidden map -o a.html",
               "--hidden map: has no steps: expected");
  expect_error("steps triangle.draw --hidden bsp -o a.png", ".html or .json");
  expect_error("steps triangle.draw --hidden bsp -o none/a.html", "none");
  expect_error("steps triangle.draw --hidden perimeter -o a.html", "surface");
  expect_error("steps triangle.draw --hidden bsp --size 0x4 -o a.html", "size");
}

TEST_F(StepsCommand, TooManyStepsAreAMessageAndNoFile) {
  expect_error("steps triangle.draw --hidden z-buffer --limit-steps 3 -o a.html",
               "more than 3 steps");
  EXPECT_EQ(run("steps triangle.draw --hidden bsp --size 8x8 --limit-steps 3 -o a.json"), 0)
      << err_;
}

}  // namespace
