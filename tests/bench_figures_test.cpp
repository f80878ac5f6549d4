// The measurements of `displayfile bench`: errors, times beside others, counts that two runs share.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <string>

#include "clip/surfaces.h"
#include "tests/bench_fixture.h"

namespace displayfile::test {
namespace {

/// Viewing's rounding decides no pixel where polygons are farther apart than that.
TEST_F(Bench, SaysWhereExactnessBegins) {
  ASSERT_EQ(run("bench parallel_sheets saw shingles coplanar_patches terrain --polygons 24 "
                "--sizes 48 --methods z-buffer --roundoff none --threads 1 --rounds 1 "
                "--seconds 0.001 --json b.json"),
            0)
      << err_;
  int far_gaps = 0, coplanar = 0;
  const Json report = json("b.json");
  for (const Json& row : report["viewing"]) {
    const std::string scene = row["scene"];
    const int different = row["different"], ties = row["different_and_tied"];
    EXPECT_LE(different, row["pixels"].get<int>()) << row;
    EXPECT_EQ(different, ties) << row;
    const std::size_t gap = scene.find("gap=1e-");
    if (scene.starts_with("coplanar_patches")) coplanar += different;
    if (gap == scene.npos || std::stoi(scene.substr(gap + 7)) > 11) continue;
    EXPECT_EQ(different, 0) << row;
    ++far_gaps;
  }
  EXPECT_EQ(far_gaps, 3 * 6);
  EXPECT_EQ(coplanar, 0);
  EXPECT_NE(shown("report.html", "b.json").find("<h2>Where exactness begins</h2>"),
            std::string::npos);
}

TEST_F(Bench, ExactMethodsHaveNoWrongPixelsAndOthersHave) {
  ASSERT_EQ(run(kTiny + "--threads 1 --json b.json"), 0) << err_;
  EXPECT_EQ(err_, "");  // no progress where there is no terminal
  std::set<std::string> exact, wrong;
  const Json report = json("b.json");
  for (const Json& cell : report["cells"]) {
    const std::string method = cell["method"];
    const int wrong_pixels = cell["wrong_pixels"];
    if (cell["exact"].get<bool>()) {
      exact.insert(method);
      EXPECT_EQ(wrong_pixels, 0) << cell;
    } else if (wrong_pixels > 0) {
      wrong.insert(method);
    }
  }
  for (const auto& entry : displayfile::hidden_methods()) {
    using enum displayfile::HiddenMethod;
    const bool of_surfaces =
        entry.method == z_buffer || entry.method == bsp || entry.method == depth_sort ||
        entry.method == displayfile::HiddenMethod::map || entry.method == scan_line ||
        entry.method == scan_line_z || entry.method == ray_cast || entry.method == warnock;
    if (!of_surfaces) continue;
    EXPECT_TRUE(exact.contains(std::string(entry.name))) << entry.name;
    EXPECT_EQ(wrong.contains(std::string(entry.name)),
              entry.method != displayfile::HiddenMethod::map)
        << entry.name << " with roundoff";
  }
  EXPECT_TRUE(wrong.contains("none"));
  EXPECT_TRUE(wrong.contains("plain-z-buffer"));
  EXPECT_FALSE(fs::exists(folder_ / "report.html.partial"));
}

/// The distance of the automatic method from the best is printed, and follows from the cells.
TEST_F(Bench, HoldsAutoAgainstTheBestFixedMethod) {
  ASSERT_EQ(run(kTiny + "--threads 1 --json b.json"), 0) << err_;
  const Json report = json("b.json");
  std::map<std::string, double> own, best;  // of each scene
  std::map<std::string, double> totals;     // of each fixed method
  for (const Json& cell : report["cells"]) {
    if (!cell["exact"].get<bool>()) continue;
    const double time = cell["time"]["median"];
    const std::string scene = cell["scene"], method = cell["method"];
    if (method == "auto") {
      own[scene] = time;
      continue;
    }
    totals[method] += time;
    best[scene] = best.contains(scene) ? std::min(best[scene], time) : time;
  }
  double worst = 0.0, total = 0.0, least = 1e300;
  for (const auto& [scene, time] : own) {
    worst = std::max(worst, time / best.at(scene));
    total += time;
  }
  for (const auto& [method, time] : totals) least = std::min(least, time);
  ASSERT_EQ(figures("b.json --json"), 0) << err_;
  const Json bounds = Json::parse(out_)["auto"];
  EXPECT_EQ(bounds["scenes"], own.size());
  EXPECT_NEAR(bounds["worst_over_best"].get<double>() / worst, 1.0, 1e-3);
  EXPECT_NEAR(bounds["total_over_best_fixed"].get<double>() / (total / least), 1.0, 1e-3);
  ASSERT_EQ(figures("b.json"), 0) << err_;
  const std::string line =
      fmt::format("at worst it takes {} times", bounds["worst_over_best"].dump());
  EXPECT_NE(out_.find(line), out_.npos) << out_;
  std::cout << "auto is " << line << " the best method on a scene\n";
}

/// On polygons that no precision confuses all that are installed see the same.
TEST_F(Bench, MeasuresThePeersThatAreInstalled) {
  write("easy.draw",
        "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n"
        "polygon-abs-3 0.1 0.1 0  0.8 0.1 0  0.8 0.7 0  0.4 0.3 0\n"
        "polygon-abs-3 0.3 0.2 -0.5  0.9 0.4 0.2  0.35 0.9 -0.2\nclose-segment\n");
  ASSERT_EQ(
      run("bench easy.draw soup --polygons 24 --sizes 32 --rounds 1 --threads 1 --json b.json"), 0)
      << err_;
  const Json report = json("b.json");
  std::map<std::string, int> cells;
  for (const Json& cell : report["cells"]) {
    const std::string method = cell["method"], scene = cell["scene"];
    if (method != "embree" && method != "gl2ps") continue;
    ++cells[method];
    EXPECT_FALSE(cell["exact"].get<bool>());
    EXPECT_FALSE(cell.contains("bytes"));
    EXPECT_EQ(cell.contains("fragments_per_polygon"), method == "gl2ps");
    if (scene != "easy.draw 32x32") continue;
    EXPECT_EQ(cell["wrong_pixels"], 0) << cell;
    EXPECT_LT(cell["largest_depth_error"], 1e-6) << cell;
  }
  const auto expected = [&](const char* name) {
    return report["environment"][name] == "not in this build" ? 0 : 2;
  };
  EXPECT_EQ(cells["embree"], expected("Embree"));
  EXPECT_EQ(cells["gl2ps"], 3 * expected("gl2ps"));  // plain, with its best root, and culled
}

/// Sheets in one plane are ties where another than the later one is shown; separate sheets are not,
/// however small the gap is. Exact methods have neither.
TEST_F(Bench, CountsTiesApart) {
  ASSERT_EQ(run("bench coplanar_patches parallel_sheets --sizes 32 --rounds 1 --threads 1 "
                "--methods z-buffer,plain-z-buffer --roundoff none --json b.json"),
            0)
      << err_;
  int tied = 0, wrong_but_not_tied = 0;
  const Json report = json("b.json");
  for (const Json& cell : report["cells"]) {
    const std::string scene = cell["scene"];
    EXPECT_GE(wrong_of(cell), 0) << cell;
    if (cell["exact"].get<bool>()) {
      EXPECT_EQ(cell["wrong_and_tied"], 0) << cell;
    }
    if (scene.starts_with("coplanar_patches")) tied += cell["wrong_and_tied"].get<int>();
    if (!scene.starts_with("parallel_sheets")) continue;
    if (scene.find("gap=1e-17") == scene.npos) {  // which rounding swallows
      EXPECT_EQ(cell["wrong_and_tied"], 0) << cell;
    }
    wrong_but_not_tied += wrong_of(cell);
  }
  EXPECT_GT(tied, 0);
  EXPECT_GT(wrong_but_not_tied, 0);
}

/// Triangles that a near square hides wholly are left out where gl2ps culls, and the picture is the
/// same.
TEST_F(Bench, Gl2psLeavesOutWhatIsHiddenWhereItCulls) {
  std::string program = "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n";
  for (int k = 0; k < 5; ++k) {
    program +=
        fmt::format("polygon-abs-3 0.3 0.3 {0}  0.6 0.3 {0}  0.4 0.6 {0}\n", -0.5 - 0.05 * k);
  }
  program += "polygon-abs-3 0.1 0.1 0  0.9 0.1 0  0.9 0.9 0  0.1 0.9 0\nclose-segment\n";
  write("hidden.draw", program);
  ASSERT_EQ(
      run("bench hidden.draw --sizes 32 --rounds 1 --threads 1 --methods gl2ps --json b.json"), 0)
      << err_;
  const Json report = json("b.json");
  if (report["environment"]["gl2ps"] == "not in this build") GTEST_SKIP() << "no gl2ps";
  std::map<std::string, double> pieces;
  for (const Json& cell : report["cells"]) {
    EXPECT_EQ(cell["wrong_pixels"], 0) << cell;
    pieces[cell["precision"]] = cell["fragments_per_polygon"].get<double>() * 7;  // triangles
  }
  EXPECT_NEAR(pieces.at("bsp, best root"), 7, 0.01);
  EXPECT_NEAR(pieces.at("bsp, best root, culled"), 2, 0.01);
}

TEST_F(Bench, TwoRunsCountTheSame) {
  ASSERT_EQ(run(kTiny + "--threads 1,2 --json a.json -o a.html"), 0) << err_;
  ASSERT_EQ(run(kTiny + "--threads 1,2 --json b.json -o b.html"), 0) << err_;
  EXPECT_EQ(counts(json("a.json")), counts(json("b.json")));
}

/// The reported ratio of a comparison with another program on `threads` threads.
double times_faster(const Json& report, int threads, const std::string& other,
                    const std::string& what) {
  for (const Json& beside : report["beside"]) {
    if (beside["threads"] == threads && beside["other"] == other && beside["what"] == what) {
      return beside["times_faster"]["median"];
    }
  }
  ADD_FAILURE() << "no " << what << " of " << other << " on " << threads;
  return 0.0;
}

/// On one thread and on two, on each side; and both draw the same.
TEST_F(Bench, HoldsOursAgainstOsmesaInEachOfItsWays) {
  write("R.md", block("osmesa", ""));
  ASSERT_EQ(run("bench soup --polygons 24 --sizes 48 --rounds 1 --threads 1,2 --json b.json"), 0)
      << err_;
  const int status = figures("b.json --readme R.md");
  const Json report = json("b.json");
  if (report["environment"]["OSMesa"].get<std::string>().find("bits") == std::string::npos) {
    EXPECT_EQ(status, 2);
    GTEST_SKIP() << "no OSMesa to be held against";
  }
  ASSERT_EQ(status, 0) << err_;
  std::string row =
      fmt::format("| soup | {} | 48 x 48 |", report["scenes"][0]["polygons"].get<int>());
  for (const int threads : {1, 2}) {
    for (const char* what : {"start-up", "new vertices", "moving camera", "same picture again"}) {
      row += ' ' + in_table(times_faster(report, threads, "OSMesa", what)) + " |";
    }
  }
  EXPECT_NE(read(folder_ / "R.md").find(row), std::string::npos) << row << read(folder_ / "R.md");
  for (const Json& beside : report["beside"]) {
    if (beside["what"] == "pixels that differ, %") {
      EXPECT_LT(beside["count"], 3.0) << beside;
    }
  }
}

TEST_F(Bench, HoldsRaysAgainstEmbreesAndPiecesAgainstThoseOfGl2ps) {
  const std::string bench = "bench soup --polygons 24 --sizes 48 --rounds 1 --threads 1 ";
  ASSERT_EQ(run(bench + "--json b.json"), 0) << err_;
  const Json report = json("b.json");
  if (report["environment"]["Embree"] != "not in this build") {
    write("R.md", block("embree", ""));
    ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
    std::string row = "| 48 x 48 |";
    for (const char* what : {"rays", "building the tree"}) {
      for (const char* other : {"Embree", "Embree, high quality"}) {
        row += ' ' + in_table(times_faster(report, 1, other, what)) + " |";
      }
    }
    EXPECT_NE(read(folder_ / "R.md").find(row), std::string::npos) << row << read(folder_ / "R.md");
  }
  if (report["environment"]["gl2ps"] == "not in this build") GTEST_SKIP() << "no gl2ps";
  std::map<std::string, double> pieces;
  for (const Json& beside : report["beside"]) {
    if (beside["what"] == "pieces a triangle") pieces[beside["other"]] = beside["count"];
  }
  for (const char* of : {"bsp", "depth-sort", "gl2ps", "gl2ps, best root"}) {
    EXPECT_GE(pieces[of], 1.0) << of;
  }
  EXPECT_GT(pieces["map"], 0.0);  // only visible ones: there may be fewer than one a triangle
  for (const char* peer : {"gl2ps", "gl2ps, best root"}) {
    EXPECT_GT(times_faster(report, 1, peer, "map"), 0.0) << peer;
  }
  EXPECT_LE(pieces["gl2ps, best root"], pieces["gl2ps"]);
  EXPECT_LE(pieces["gl2ps, best root, culled"], pieces["gl2ps, best root"]);
  if (report["environment"]["Embree"] == "not in this build") GTEST_SKIP() << "no Embree";
}

/// The cost of exactness of each exact method is reported once: in the JSON and in a row of the
/// table. The other side is the same code: on a scene with few rounding errors hardly a pixel is
/// wrong.
TEST_F(Bench, HoldsEachExactMethodAgainstItselfWithoutItsExactStages) {
  write("R.md", block("exactness", ""));
  ASSERT_EQ(run("bench soup --polygons 24 --sizes 32 --rounds 1 --threads 1 --json b.json"), 0)
      << err_;
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  std::set<std::string> methods, exact;
  const Json report = json("b.json");
  const std::string table = read(folder_ / "R.md");
  for (const Json& beside : report["beside"]) {
    if (beside["other"] != "without exact stages") continue;
    const std::string method = beside["what"];
    EXPECT_TRUE(methods.insert(method).second) << method << " twice";
    EXPECT_GT(beside["times_faster"]["median"], 0.0);
    EXPECT_LE(beside["count"], 8.0) << beside;  // of 1024: edges are rounded too
    EXPECT_NE(table.find(fmt::format("| {} | ", method)), table.npos) << method << table;
  }
  for (const Json& cell : report["cells"]) {
    if (cell["exact"].get<bool>() && cell["method"] != "auto") {
      exact.insert(cell["method"].get<std::string>());
    }
  }
  exact.erase("map");  // which is always exact
  EXPECT_EQ(methods, exact);
}

/// A square in front of one that it hides and of one of which it leaves an L: the sorts keep all
/// three, and the map has two pieces. All show the same.
TEST_F(Bench, CountsThePiecesOfTheMapThatAreSeen) {
  write("squares.draw",
        "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n"
        "polygon-abs-3 0.2 0.2 0  0.6 0.2 0  0.6 0.6 0  0.2 0.6 0\n"
        "polygon-abs-3 0.3 0.3 -0.2  0.5 0.3 -0.2  0.5 0.5 -0.2  0.3 0.5 -0.2\n"
        "polygon-abs-3 0.4 0.4 -0.4  0.8 0.4 -0.4  0.8 0.8 -0.4  0.4 0.8 -0.4\nclose-segment\n");
  write("R.md", block("methods", "") + block("advice", ""));
  ASSERT_EQ(run("bench squares.draw --sizes 32 --rounds 1 --threads 1,2 --methods "
                "z-buffer,bsp,depth-sort,map --json b.json -o p.html"),
            0)
      << err_;
  std::map<std::string, int> cells;
  const Json report = json("b.json");
  for (const Json& cell : report["cells"]) {
    const std::string method = cell["method"];
    ++cells[method];
    EXPECT_EQ(cell["wrong_pixels"], 0) << cell;
    EXPECT_LT(cell["largest_depth_error"], 1e-9) << cell;
    EXPECT_EQ(cell.contains("fragments_per_polygon"), method != "z-buffer") << cell;
    if (method == "bsp" || method == "depth-sort") {
      EXPECT_EQ(cell["fragments_per_polygon"], 1.0) << cell;
    }
    if (method == "map") {
      EXPECT_NEAR(cell["fragments_per_polygon"], 2.0 / 3.0, 1e-4) << cell;
      EXPECT_GT(cell["bytes"], 0) << cell;
    }
  }
  EXPECT_EQ(cells["map"], 2);  // exact, on one thread and on two
  for (const char* row : {"  map         exact           1  ", "  map         exact           2  ",
                          "  bsp         roundoff=1e-6   1  "}) {
    EXPECT_NE(out_.find(row), out_.npos) << row << out_;
  }
  const std::string page = shown("p.html", "b.json");
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  const std::string readme = read(folder_ / "R.md");
  EXPECT_NE(page.find("map, exact</span>"), page.npos);
  EXPECT_NE(readme.find("| map, exact |"), readme.npos) << readme;
  // The fewest pieces are the smallest file.
  EXPECT_NE(readme.find("| A plot in a paper: vectors, drawn once | map, exact |"), readme.npos)
      << readme;
}

TEST_F(Bench, RefusesAReadmeThatIsNotMarkedWell) {
  ASSERT_EQ(run("bench soup --polygons 9 --sizes 8 --rounds 1 --threads 1 --methods none "
                "--json b.json"),
            0)
      << err_;
  const auto refused = [&](const std::string& text, const std::string& words) {
    write("R.md", text);
    EXPECT_EQ(figures("b.json --readme R.md"), 2) << words;
    EXPECT_NE(err_.find(words), err_.npos) << err_;
    EXPECT_EQ(read(folder_ / "R.md"), text);
  };
  refused("a\n" + block("sped", "x\n"), "R.md:2: no such block 'sped'");
  refused("a\n\n<!-- bench: methods -->\nx\n", "R.md:3: the block 'methods' has no end");
  refused("<!-- bench: methods -->\n" + block("osmesa", ""),
          "R.md:1: the block 'methods' has no end");
  refused("a\n<!-- bench: end -->\n", "R.md:2: the end of no block");
  refused("a\n", "R.md: no block");
  // The report of another version.
  write("old.json", R"({"format": 2, "scenes": []})");
  EXPECT_EQ(figures("old.json --readme R.md"), 2);
  EXPECT_NE(err_.find("a report of format 2: expected 3"), err_.npos) << err_;
  // A run without figures for a block.
  refused("a\n" + block("wrong-pixels", "x\n"),
          "R.md:2: this run has no figures for the block 'wrong-pixels'");
}

}  // namespace
}  // namespace displayfile::test
