// The counts of `displayfile bench` for each feature, off and on.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include "tests/bench_fixture.h"

namespace displayfile::test {
namespace {

const std::string kFeatures =
    "bench soup --polygons 12 --sizes 16 --rounds 1 --methods none --threads 1 --features ";

bool valgrind_is_installed() {
  return std::system("valgrind --version >/dev/null 2>/dev/null") == 0;
}

/// No feature costs anything when it is off; every one costs something when it is on.
TEST_F(Bench, FeaturesCostNothingWhenTheyAreOff) {
  ASSERT_EQ(run(kFeatures + "--json f.json"), 0) << err_;
  const Json costs = json("f.json")["feature_costs"];
  EXPECT_EQ(costs["off"]["display_file_bytes_a_polygon"], 0.0);
  EXPECT_EQ(costs.contains("instructions_not_counted"), !valgrind_is_installed()) << costs;
  EXPECT_EQ(costs["off"].contains("instructions"), valgrind_is_installed());
  EXPECT_GT(costs["off"]["allocations"], 0);
  EXPECT_GE(costs["features"].size(), 30u);
  for (const Json& feature : costs["features"]) {
    const Json& off = feature["off"];
    const Json& on = feature["on"];
    const bool counted = valgrind_is_installed();
    EXPECT_EQ(off.contains("own_instructions"), counted && feature["has_functions"].get<bool>());
    if (off.contains("own_instructions")) {
      EXPECT_EQ(off["own_instructions"], 0) << feature;
      EXPECT_EQ(off["own_allocations"], 0) << feature;
    }
    if (on.contains("not_counted")) continue;
    EXPECT_GT(on["allocations"], 0) << feature;
    EXPECT_GT(on["most_bytes"], 0) << feature;
    if (feature["has_functions"].get<bool>() && counted) {
      EXPECT_GT(on["own_instructions"], 0) << feature;
      EXPECT_LE(on["own_allocations"], on["allocations"]) << feature;
    }
    if (counted) {
      EXPECT_NE(on["instructions"], off["instructions"]) << feature;
    }
  }
}

TEST_F(Bench, FeaturesAreCountedTheSameAgainAndShownEverywhere) {
  ASSERT_EQ(run(kFeatures + "--json a.json -o a.html"), 0) << err_;
  const Json first = json("a.json")["feature_costs"];
  const std::string text = out_, page = shown("a.html", "a.json");
  for (const Json& feature : first["features"]) {
    const std::string name = feature["feature"];
    const std::size_t row = page.find(fmt::format("<tr><td>{}<br>", name));
    ASSERT_NE(row, page.npos) << name;
    const auto shown = fields(page.substr(row, page.find('\n', row) - row));
    for (const char* count : {"instructions", "own_instructions", "own_allocations"}) {
      if (!feature["on"].contains(count)) continue;
      EXPECT_NE(std::ranges::find(shown, feature["on"][count].dump()), shown.end())
          << name << ": " << count;
    }
    EXPECT_NE(text.find("  " + name), text.npos) << name;
  }
  ASSERT_EQ(run(kFeatures + "--json b.json -o b.html"), 0) << err_;
  EXPECT_EQ(json("b.json")["feature_costs"], first);
}

/// A missing valgrind, and one that cannot run the command.
TEST_F(Bench, SaysWhereInstructionsAreNotCounted) {
  write("valgrind", "#!/bin/sh\necho it cannot >&2\nexit 1\n");
  fs::permissions(folder_ / "valgrind", fs::perms::owner_all);
  const std::string before = std::getenv("PATH");
  for (const auto& [path, why] : {std::pair("nowhere", "valgrind is not installed"),
                                  std::pair(".:/usr/bin:/bin", "valgrind failed: it cannot")}) {
    setenv("PATH", path, 1);
    const int status = run(kFeatures + "--json f.json");
    setenv("PATH", before.c_str(), 1);
    ASSERT_EQ(status, 0) << err_;
    const Json costs = json("f.json")["feature_costs"];
    EXPECT_EQ(costs["instructions_not_counted"], why);
    EXPECT_NE(out_.find(why), std::string::npos) << out_;
    EXPECT_NE(shown("report.html", "f.json").find(why), std::string::npos);
    EXPECT_FALSE(costs["features"][0]["on"].contains("instructions"));
    EXPECT_GT(costs["features"][0]["on"]["allocations"], 0);
  }
}

TEST_F(Bench, FeaturesAreLeftOutWhereScenesAreNamed) {
  ASSERT_EQ(run(kTiny + "--methods none --threads 1 --json b.json"), 0) << err_;
  EXPECT_FALSE(json("b.json").contains("feature_costs"));
  EXPECT_EQ(shown("report.html", "b.json").find("Pay for what is used"), std::string::npos);
}

}  // namespace
}  // namespace displayfile::test
