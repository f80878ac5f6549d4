// `displayfile bench` as its users meet it: what the JSON and the page hold, and what is kept of a
// run that was interrupted.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "hidden/hidden_method.h"
#include "tests/command_fixture.h"

namespace {

using Json = nlohmann::ordered_json;

const std::string kTiny = "bench soup cycle_of_3 --polygons 12,24 --sizes 16,24 --rounds 1 ";

class Bench : public Command {
 protected:
  Json json(const std::string& name) { return Json::parse(read(folder_ / name)); }

  /// Runs the command and ends it when so many lines of the partial file are written.
  void interrupt(const std::string& arguments, int lines) {
    const std::string line = fmt::format(
        "cd '{}'; '{}' {} >.out 2>.err & run=$!; until [ ! -d /proc/$run ] || "
        "[ \"$(cat report.html.partial 2>.err | wc -l)\" -ge {} ]; do :; done; "
        "kill -9 $run; wait $run",
        folder_.string(), DISPLAYFILE_COMMAND, arguments, lines);
    EXPECT_NE(std::system(line.c_str()), 0) << "it was faster than the interruption";
  }
};

/// What does not hang on time.
Json counts(Json report) {
  for (Json& beside : report["beside"]) beside.erase("times_faster");
  report.erase("fits");
  report.erase("auto");
  for (Json& scene : report["scenes"]) scene.erase("reference_growth");
  for (Json& cell : report["cells"]) {
    cell.erase("time");
    cell.erase("time_again");
    if (cell["threads"] != 1) cell.erase("bytes");  // threads share out the work as it comes
  }
  return report;
}

/// The numbers of a cell, as they stand in the JSON and in the page's row.
std::vector<std::string> figures(const Json& cell) {
  std::vector<std::string> texts;
  for (const char* name : {"wrong_pixels", "largest_depth_error", "mean_depth_error",
                           "fragments_per_polygon", "bytes", "exact_stage_calls"}) {
    texts.push_back(cell.contains(name) ? cell[name].dump() : "");
  }
  for (const char* name : {"time", "time_again"}) {
    for (const char* part : {"median", "least", "greatest"}) {
      texts.push_back(cell.contains(name) ? cell[name][part].dump() : "");
    }
  }
  return texts;
}

/// The fields of a row of a table in HTML.
std::vector<std::string> fields(const std::string& row) {
  std::vector<std::string> texts;
  for (std::size_t at = row.find("<td"); at != row.npos;) {
    const std::size_t start = row.find('>', at) + 1;
    at = row.find("<td", start);
    texts.push_back(row.substr(start, at == row.npos ? at : at - start));
  }
  return texts;
}

/// What viewing rounds decides no pixel where polygons are farther apart than that.
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
  EXPECT_GT(coplanar, 0);
  EXPECT_NE(read(folder_ / "report.html").find("<h2>Where exactness begins</h2>"),
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
    const bool of_surfaces = entry.method == z_buffer || entry.method == bsp ||
                             entry.method == depth_sort || entry.method == scan_line ||
                             entry.method == scan_line_z || entry.method == ray_cast ||
                             entry.method == warnock;
    if (!entry.available || !of_surfaces) continue;
    EXPECT_TRUE(exact.contains(std::string(entry.name))) << entry.name;
    EXPECT_TRUE(wrong.contains(std::string(entry.name))) << entry.name << " with roundoff";
  }
  EXPECT_TRUE(wrong.contains("none"));
  EXPECT_TRUE(wrong.contains("plain-z-buffer"));
  EXPECT_FALSE(fs::exists(folder_ / "report.html.partial"));
}

/// How far the method that picks itself is from the best is printed, and follows from the cells.
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
  const Json& bounds = report["auto"];
  EXPECT_EQ(bounds["scenes"], own.size());
  EXPECT_NEAR(bounds["worst_over_best"].get<double>() / worst, 1.0, 1e-3);
  EXPECT_NEAR(bounds["total_over_best_fixed"].get<double>() / (total / least), 1.0, 1e-3);
  const std::string line = fmt::format("at worst {} times", bounds["worst_over_best"].dump());
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
  EXPECT_EQ(cells["gl2ps"], 2 * expected("gl2ps"));  // with its best root, and without
}

TEST_F(Bench, TwoRunsCountTheSame) {
  ASSERT_EQ(run(kTiny + "--threads 1,2 --json a.json -o a.html"), 0) << err_;
  ASSERT_EQ(run(kTiny + "--threads 1,2 --json b.json -o b.html"), 0) << err_;
  EXPECT_EQ(counts(json("a.json")), counts(json("b.json")));
}

TEST_F(Bench, PageHoldsEveryFigure) {
  write("t.draw",
        "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n"
        "polygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n");
  ASSERT_EQ(run(kTiny + "walk t.draw --threads 1,2 --json b.json -o p.html"), 0) << err_;
  const std::string page = read(folder_ / "p.html");
  const Json report = json("b.json");
  std::map<std::string, std::string> tables;  // of each scene
  for (const Json& scene : report["scenes"]) {
    const std::string id = scene["scene"];
    const std::size_t start = page.find(fmt::format("<summary>{}: ", id));
    ASSERT_NE(start, page.npos) << id;
    tables[id] = page.substr(start, page.find("</details>", start) - start);
    EXPECT_NE(tables[id].find(scene["polygons"].dump() + " polygons"), page.npos) << id;
  }
  for (const Json& cell : report["cells"]) {
    const std::string& table = tables[cell["scene"]];
    const std::string head =
        fmt::format("<tr><td>{}<td class='l'>{}<td>{}<td>", cell["method"].get<std::string>(),
                    cell["precision"].get<std::string>(), cell["threads"].get<int>());
    const std::size_t start = table.find(head);
    ASSERT_NE(start, table.npos) << head;
    const auto row = fields(table.substr(start, table.find('\n', start) - start));
    const std::vector<std::string> shown(row.begin() + 4, row.end());
    EXPECT_EQ(shown, figures(cell)) << head;
  }
  ASSERT_FALSE(report["beside"].empty());
  for (const Json& beside : report["beside"]) {
    std::string row =
        fmt::format("<tr><td>{}<td>{}<td class='l'>{}<td class='l'>{}<td>",
                    beside["scene"].get<std::string>(), beside["threads"].get<int>(),
                    beside["other"].get<std::string>(), beside["what"].get<std::string>());
    if (beside.contains("times_faster")) {
      const Json& faster = beside["times_faster"];
      row += fmt::format("{}<td>{}<td>{}<td>", faster["median"].dump(), faster["least"].dump(),
                         faster["greatest"].dump());
    } else {
      row += "<td><td><td>";
    }
    if (beside.contains("count")) row += beside["count"].dump();
    EXPECT_NE(page.find(row + '\n'), page.npos) << row;
  }
  for (const Json& fit : report["fits"]) {
    EXPECT_NE(page.find(fit["exponent"].dump() + " <small>"), page.npos) << fit;
  }
  for (const auto& [name, value] : report["environment"].items()) {
    EXPECT_NE(page.find(name), page.npos);
  }
  EXPECT_EQ(page.find("<script"), page.npos);
  EXPECT_EQ(page.find("http"), page.npos);
}

std::string block(const std::string& name, const std::string& text) {
  return fmt::format("<!-- bench: {} -->\n{}<!-- bench: end -->\n", name, text);
}

/// A line of Markdown as the page has it.
std::string on_page(const std::string& line) {
  if (!line.starts_with("| ")) return line;
  std::string row;
  for (std::size_t at = 1; at + 1 < line.size();) {
    const std::size_t end = line.find('|', at);
    row += "<td>" + (end - at < 3 ? "" : line.substr(at + 1, end - at - 2));
    at = end + 1;
  }
  return row;
}

TEST_F(Bench, WritesAReadmesBlocksFromTheReport) {
  const std::string before = "# A title\n\n", after = "\n| no | block |\n";
  const std::vector<std::string> names{"front",  "methods", "exactness",
                                       "advice", "auto",    "wrong-pixels"};
  std::string readme = before;
  for (const std::string& name : names) readme += block(name, "old\n\n| old |\n") + after;
  write("R.md", readme);
  ASSERT_EQ(run(kTiny + "--threads 1 --json b.json -o p.html --readme R.md"), 0) << err_;
  const std::string written = read(folder_ / "R.md");
  std::string page = read(folder_ / "p.html");
  constexpr std::string_view kToTheLeft = " class='l'";
  for (std::size_t at = 0; (at = page.find(kToTheLeft, at)) != page.npos;) {
    page.erase(at, kToTheLeft.size());
  }
  constexpr std::string_view kApostrophe = "&#39;";
  for (std::size_t at = 0; (at = page.find(kApostrophe, at)) != page.npos;) {
    page.replace(at, kApostrophe.size(), "'");
  }
  EXPECT_EQ(written.find("old"), written.npos);
  EXPECT_TRUE(written.starts_with(before));
  EXPECT_TRUE(written.ends_with(after));
  std::size_t rows = 0;
  for (const std::string& name : names) {
    const std::string open = block(name, "").substr(0, block(name, "").find('\n') + 1);
    const std::size_t start = written.find(open);
    ASSERT_NE(start, written.npos) << name;
    const std::size_t end = written.find("<!-- bench: end -->\n" + after, start);
    ASSERT_NE(end, written.npos) << name;
    std::istringstream lines(written.substr(start + open.size(), end - start - open.size()));
    bool head = true;
    for (std::string line; std::getline(lines, line);) {
      const bool is_row = line.starts_with("| ");
      if (line.starts_with("|--") || (is_row && std::exchange(head, false))) continue;
      EXPECT_NE(page.find(on_page(line)), page.npos) << name << ": " << on_page(line);
      rows += is_row;
    }
  }
  EXPECT_GT(rows, 20u);
  // Sums of the JSON's counts.
  const Json report = json("b.json");
  std::map<std::string, int> wrong;
  for (const Json& cell : report["cells"]) {
    const std::string scene = cell["scene"];
    if (!scene.starts_with("cycle_of_3 ") || cell.contains("skipped")) continue;
    wrong[cell["method"].get<std::string>() + ' ' + cell["precision"].get<std::string>()] +=
        cell["wrong_pixels"].get<int>();
  }
  EXPECT_GT(wrong.at("none "), 0);
  EXPECT_NE(written.find(fmt::format("| none | | | | | {} |", wrong.at("none "))), written.npos)
      << written;
  EXPECT_NE(written.find(fmt::format("| bsp | 0 | {} | {} | {} | |", wrong.at("bsp roundoff=1e-12"),
                                     wrong.at("bsp roundoff=1e-9"), wrong.at("bsp roundoff=1e-6"))),
            written.npos)
      << written;
  // The same command again: only figures change.
  ASSERT_EQ(run(kTiny + "--threads 1 --readme R.md"), 0) << err_;
  EXPECT_EQ(std::ranges::count(read(folder_ / "R.md"), '\n'), std::ranges::count(written, '\n'));
}

/// The page begins with the plot of all, which is a file of its own too; who is on its front
/// follows from the cells.
TEST_F(Bench, ThePageBeginsWithSpeedAgainstErrorOfAll) {
  write("R.md", block("front", ""));
  ASSERT_EQ(run(kTiny + "--threads 1 --json b.json -o p.html --plot front.svg --readme R.md"), 0)
      << err_;
  const std::string page = read(folder_ / "p.html"), plot = read(folder_ / "front.svg");
  EXPECT_LT(page.find("<svg"), page.find("<table"));
  EXPECT_LT(page.find("<table"), page.find("<h2>Error against time"));
  EXPECT_TRUE(plot.starts_with("<svg xmlns='http://www.w3.org/2000/svg'")) << plot.substr(0, 99);
  std::map<std::string, double> times;                      // of the scene with the most polygons
  std::map<std::string, std::pair<double, double>> errors;  // of the hard cases
  const Json report = json("b.json");
  std::string largest;
  std::map<std::string, double> pixels;
  for (const Json& scene : report["scenes"]) {
    pixels[scene["scene"]] = scene["pixels"];
    if (scene["kind"] != "hard case" && scene["scene"].get<std::string>().starts_with("soup n=24 "))
      largest = scene["scene"];
  }
  for (const Json& cell : report["cells"]) {
    const std::string precision = cell["precision"], scene = cell["scene"];
    const std::string name =
        cell["method"].get<std::string>() + (precision.empty() ? "" : ", " + precision);
    if (cell["method"] == "auto") continue;  // it is one of the others
    ASSERT_FALSE(cell.contains("skipped")) << cell;
    EXPECT_NE(plot.find(name), plot.npos) << name;
    if (scene == largest) times[name] = cell["time"]["median"];
    if (!scene.starts_with("cycle_of_3")) continue;
    errors[name].first += cell["wrong_pixels"].get<double>();
    errors[name].second += pixels[scene];
  }
  ASSERT_GT(times.size(), 20u);
  const std::string written = read(folder_ / "R.md");
  for (const auto& timed : times) {
    const auto& name = timed.first;
    const double time = timed.second;
    const auto error_of = [&](const std::string& of) {
      return errors.at(of).first / errors.at(of).second;
    };
    const bool beaten = std::ranges::any_of(times, [&](const auto& other) {
      return other.second < time && error_of(other.first) <= error_of(name);
    });
    const bool on_front =
        written.find(fmt::format(" {} (time {:.3g}, ", name, time)) != written.npos;
    EXPECT_EQ(on_front, !beaten) << name << '\n' << written;
  }
}

/// A ratio as the tables have it.
std::string in_table(double ratio) {
  return fmt::format("{:.{}f}", ratio, ratio < 1.0 ? 2 : ratio < 9.95 ? 1 : 0);
}

/// What the report tells of a comparison with another on so many threads.
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
  const int status = run(
      "bench soup --polygons 24 --sizes 48 --rounds 1 --threads 1,2 --json b.json --readme R.md");
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
    ASSERT_EQ(run(bench + "--json e.json --readme R.md"), 0) << err_;
    const Json again = json("e.json");
    std::string row = "| 48 x 48 |";
    for (const char* what : {"rays", "building the tree"}) {
      for (const char* other : {"Embree", "Embree, high quality"}) {
        row += ' ' + in_table(times_faster(again, 1, other, what)) + " |";
      }
    }
    EXPECT_NE(read(folder_ / "R.md").find(row), std::string::npos) << row << read(folder_ / "R.md");
  }
  if (report["environment"]["gl2ps"] == "not in this build") return;
  std::map<std::string, double> pieces;
  for (const Json& beside : report["beside"]) {
    if (beside["what"] == "pieces a triangle") pieces[beside["other"]] = beside["count"];
  }
  for (const char* of : {"bsp", "depth-sort", "gl2ps", "gl2ps, best root"}) {
    EXPECT_GE(pieces[of], 1.0) << of;
  }
  EXPECT_LE(pieces["gl2ps, best root"], pieces["gl2ps"]);
}

/// The same code, not another: on a scene that rounding hardly confuses hardly a pixel is wrong.
TEST_F(Bench, HoldsEachExactMethodAgainstItselfWithoutItsExactStages) {
  ASSERT_EQ(run("bench soup --polygons 24 --sizes 32 --rounds 1 --threads 1 --json b.json"), 0)
      << err_;
  std::set<std::string> methods, exact;
  const Json report = json("b.json");
  for (const Json& beside : report["beside"]) {
    if (beside["other"] != "without exact stages") continue;
    methods.insert(beside["what"].get<std::string>());
    EXPECT_GT(beside["times_faster"]["median"], 0.0);
    EXPECT_LE(beside["count"], 8.0) << beside;  // of 1024: edges are rounded too
  }
  for (const Json& cell : report["cells"]) {
    if (cell["exact"].get<bool>() && cell["method"] != "auto") {
      exact.insert(cell["method"].get<std::string>());
    }
  }
  EXPECT_EQ(methods, exact);
}

/// A sort that would take too long is said to be skipped, with the reason, and nothing is advised
/// from the scene.
TEST_F(Bench, SaysWhatWasSkippedAndAdvisesNothingFromIt) {
  write("R.md", block("exactness", "") + block("advice", ""));
  ASSERT_EQ(run("bench planes soup --polygons 10,20,60 --sizes 32 --rounds 1 --threads 1 --seconds "
                "0.001 --methods z-buffer,depth-sort --roundoff none --json b.json --readme R.md"),
            0)
      << err_;
  const std::string written = read(folder_ / "R.md");
  std::set<std::string> skipped;  // scenes on which an exact method was
  const Json report = json("b.json");
  for (const Json& cell : report["cells"]) {
    if (cell["exact"].get<bool>() && cell.contains("skipped")) {
      skipped.insert(cell["scene"].get<std::string>());
    }
  }
  ASSERT_TRUE(skipped.contains("planes n=60 32x32")) << written;
  EXPECT_NE(written.find(" Skipped: depth-sort: planes n=60 32x32, it would take too long, from "
                         "what a smaller one took."),
            written.npos)
      << written;
  if (skipped.contains("soup n=60 32x32")) {
    EXPECT_EQ(written.find("| Any other picture"), written.npos) << written;
  } else {
    EXPECT_NE(written.find("over 1 scene (1 more, from which an exact method was left out, do not"),
              written.npos)
        << written;
  }
}

/// One scene is measured, so that each method's time is its median.
TEST_F(Bench, AdvisesTheFirstOfTheMethodsThatNoneIsClearlyFasterThan) {
  write("R.md", block("advice", ""));
  ASSERT_EQ(run("bench soup --polygons 24 --sizes 24 --roundoff none --threads 1 --rounds 3 "
                "--json b.json --readme R.md"),
            0)
      << err_;
  constexpr double kClearly = 0.9;
  std::vector<std::pair<std::string, double>> exact;
  double least = 1e300;
  const Json report = json("b.json");
  for (const Json& cell : report["cells"]) {
    if (!cell["exact"].get<bool>() || cell["method"] == "auto") continue;
    exact.emplace_back(cell["method"].get<std::string>(), cell["time"]["median"].get<double>());
    least = std::min(least, exact.back().second);
  }
  const auto first = std::ranges::find_if(
      exact, [&](const auto& method) { return kClearly * method.second <= least; });
  ASSERT_NE(first, exact.end());
  const std::string written = read(folder_ / "R.md");
  EXPECT_NE(written.find("| Any other picture of pixels | " + first->first + ", exact |"),
            written.npos)
      << written << first->first;
}

TEST_F(Bench, RefusesAReadmeThatIsNotMarkedWell) {
  const auto refused = [&](const std::string& text, const std::string& words) {
    write("R.md", text);
    expect_error("bench soup --polygons 9 --sizes 8 --readme R.md", words);
    EXPECT_EQ(read(folder_ / "R.md"), text);
  };
  refused("a\n" + block("sped", "x\n"), "R.md:2: no such block 'sped'");
  refused("a\n\n<!-- bench: auto -->\nx\n", "R.md:3: the block 'auto' has no end");
  refused("<!-- bench: auto -->\n" + block("osmesa", ""), "R.md:1: the block 'auto' has no end");
  refused("a\n<!-- bench: end -->\n", "R.md:2: the end of no block");
  refused("a\n", "R.md: no block");
  expect_error("bench soup --readme nowhere.md", "nowhere.md");
  // A run without figures for a block.
  const std::string text = "a\n" + block("wrong-pixels", "x\n");
  write("R.md", text);
  EXPECT_EQ(run("bench soup --polygons 9 --sizes 8 --rounds 1 --threads 1 --methods none "
                "--readme R.md"),
            2);
  EXPECT_NE(err_.find("R.md:2: this run has no figures for the block 'wrong-pixels'"), err_.npos)
      << err_;
  EXPECT_EQ(read(folder_ / "R.md"), text);
}

TEST_F(Bench, AnInterruptedRunGoesOn) {
  const std::string bench = kTiny + "--threads 1 --json b.json";
  ASSERT_EQ(run(bench), 0) << err_;
  const Json whole = json("b.json");
  fs::remove(folder_ / "b.json");
  fs::remove(folder_ / "report.html");
  interrupt(bench, 12);
  const fs::path partial = folder_ / "report.html.partial";
  ASSERT_TRUE(fs::exists(partial));
  EXPECT_FALSE(fs::exists(folder_ / "b.json"));
  EXPECT_FALSE(fs::exists(folder_ / "report.html"));
  // The last line is cut off in its middle.
  fs::resize_file(partial, fs::file_size(partial) - 20);
  const std::string kept = read(partial);
  const auto lines = std::ranges::count(kept, '\n');
  ASSERT_EQ(run(bench), 0) << err_;
  EXPECT_NE(out_.find(fmt::format(" {} taken over", lines - 1)), out_.npos) << out_;
  EXPECT_EQ(counts(json("b.json")), counts(whole));
  EXPECT_FALSE(fs::exists(partial));
  // What was measured before is what is reported.
  const std::size_t second = kept.find('\n') + 1;
  const Json first = Json::parse(kept.substr(second, kept.find('\n', second) - second));
  EXPECT_EQ(json("b.json")["cells"][0], first["cell"]);
}

TEST_F(Bench, AnotherBuildsFiguresAreNotTakenOver) {
  write("report.html.partial", "{\"displayfile_bench\":1,\"of\":\"another\"}\nnonsense\n");
  ASSERT_EQ(run(kTiny + "--methods none --threads 1"), 0) << err_;
  EXPECT_NE(out_.find(" 0 taken over"), out_.npos) << out_;
}

const std::string kFeatures =
    "bench soup --polygons 12 --sizes 16 --rounds 1 --methods none --threads 1 --features ";

bool valgrind_is_installed() {
  return std::system("valgrind --version >/dev/null 2>/dev/null") == 0;
}

/// No feature costs anything when it is off; every one does something when it is on.
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
  const std::string page = read(folder_ / "a.html"), text = out_;
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

/// A valgrind that is not there, and one that cannot run the command.
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
    EXPECT_NE(read(folder_ / "report.html").find(why), std::string::npos);
    EXPECT_NE(out_.find(why), std::string::npos) << out_;
    EXPECT_FALSE(costs["features"][0]["on"].contains("instructions"));
    EXPECT_GT(costs["features"][0]["on"]["allocations"], 0);
  }
}

TEST_F(Bench, FeaturesAreLeftOutWhereScenesAreNamed) {
  ASSERT_EQ(run(kTiny + "--methods none --threads 1 --json b.json"), 0) << err_;
  EXPECT_FALSE(json("b.json").contains("feature_costs"));
  EXPECT_EQ(read(folder_ / "report.html").find("Pay for what is used"), std::string::npos);
}

/// What measures stands beside the command; a command by itself says so.
TEST_F(Bench, SaysThatItsProgramIsNotThere) {
  fs::copy_file(DISPLAYFILE_COMMAND, folder_ / "alone");
  const std::string line = "cd '" + folder_.string() + "' && ./alone bench soup >.out 2>.err";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 2);
  const std::string message = read(folder_ / ".err");
  EXPECT_NE(message.find("displayfile-bench cannot be started"), message.npos) << message;
  EXPECT_NE(message.find("neither is there"), message.npos) << message;
}

/// Wherever the command's own parser ends, the program's says what it takes.
TEST_F(Bench, HelpIsThatOfTheProgram) {
  for (const char* line : {"bench --help", "bench -h", "--help bench", "bench soup --help"}) {
    ASSERT_EQ(run(line), 0) << line;
    EXPECT_NE(out_.find("Usage: displayfile bench [OPTIONS] [SCENE...]"), out_.npos) << out_;
    EXPECT_NE(out_.find("--readme"), out_.npos) << out_;
  }
  ASSERT_EQ(run("--help"), 0);
  EXPECT_NE(out_.find("Speed against error of every method"), out_.npos) << out_;
}

TEST_F(Bench, Refuses) {
  expect_error("bench nowhere", "nowhere: no such scene or file");
  expect_error("bench soup -o nowhere/r.html", "nowhere/r.html");
  expect_error("bench soup --json nowhere/r.json", "nowhere/r.json");
  expect_error("bench soup --methods roberts", "roberts");
  expect_error("bench soup --roundoff 2", "roundoff");
  write("bad.draw", "open-segment 1\npolygon-abs-3 0 0 0  1 0 0\nclose-segment\n");
  expect_error("bench bad.draw", "bad.draw:2:");
  EXPECT_EQ(run("bench soup --sizes 0"), 2);
  EXPECT_EQ(run("bench soup --threads none"), 2);
}

}  // namespace
