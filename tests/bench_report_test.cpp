// The output of `displayfile bench`: the page, the plot and the blocks of a README.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench_fixture.h"

namespace displayfile::test {
namespace {

/// The numbers of a cell in the order of the page's row; null where there is none.
std::vector<Json> numbers_of(const Json& cell, const std::vector<const char*>& names) {
  std::vector<Json> numbers;
  for (const char* name : names) numbers.push_back(cell.value(name, Json()));
  for (const char* name : {"time", "time_again"}) {
    if (std::string(name) == "time_again" && cell.contains("lines")) continue;
    for (const char* part : {"median", "least", "greatest"}) {
      numbers.push_back(cell.contains(name) ? cell[name][part] : Json());
    }
  }
  return numbers;
}

/// The same of the fields of a row, from the fourth on.
std::vector<Json> numbers_in(const std::vector<std::string>& row) {
  std::vector<Json> numbers;
  for (std::size_t k = 4; k < row.size(); ++k) {
    numbers.push_back(row[k].empty() ? Json() : Json::parse(row[k]));
  }
  return numbers;
}

/// The row of a cell, in the table of its scene.
std::vector<std::string> row_in(const std::string& table, const Json& cell) {
  const std::string head =
      fmt::format("<tr><td>{}<td class='l'>{}<td>{}<td>", cell["method"].get<std::string>(),
                  cell["precision"].get<std::string>(), cell["threads"].get<int>());
  const std::size_t start = table.find(head);
  EXPECT_NE(start, table.npos) << head;
  if (start == table.npos) return {};
  return fields(table.substr(start, table.find('\n', start) - start));
}

/// A number as the page's script writes it.
std::string as_shown(const Json& number) {
  const double value = number;
  const std::string text = number.dump();
  return value == std::floor(value) && text.ends_with(".0") ? text.substr(0, text.size() - 2)
                                                            : text;
}

TEST_F(Bench, PageHoldsEveryFigure) {
  write("t.draw",
        "set-window 0 1 0 1\nset-line-style none\nopen-segment 1\n"
        "polygon-abs-3 0 0 0  1 0 0  0 1 0\nclose-segment\n");
  ASSERT_EQ(run(kTiny + "walk t.draw --threads 1,2 --json b.json -o p.html"), 0) << err_;
  const std::string file = read(folder_ / "p.html"), page = shown("p.html", "b.json");
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
    EXPECT_EQ(numbers_in(row_in(tables[cell["scene"]], cell)),
              numbers_of(cell, {"wrong_pixels", "wrong_and_tied", "largest_depth_error",
                                "mean_depth_error", "fragments_per_polygon", "bytes",
                                "exact_stage_calls"}))
        << cell;
  }
  ASSERT_FALSE(report["beside"].empty());
  for (const Json& beside : report["beside"]) {
    std::string row =
        fmt::format("<tr><td>{}<td>{}<td class='l'>{}<td class='l'>{}<td>",
                    beside["scene"].get<std::string>(), beside["threads"].get<int>(),
                    beside["other"].get<std::string>(), beside["what"].get<std::string>());
    if (beside.contains("times_faster")) {
      const Json& faster = beside["times_faster"];
      row += fmt::format("{}<td>{}<td>{}<td>", as_shown(faster["median"]),
                         as_shown(faster["least"]), as_shown(faster["greatest"]));
    } else {
      row += "<td><td><td>";
    }
    if (beside.contains("count")) row += as_shown(beside["count"]);
    EXPECT_NE(page.find(row + '\n'), page.npos) << row;
  }
  ASSERT_EQ(figures("b.json --json"), 0) << err_;
  const Json derived = Json::parse(out_);
  EXPECT_FALSE(derived["fits"].empty());
  for (const Json& fit : derived["fits"]) {
    EXPECT_NE(page.find(fit["exponent"].dump() + " <small>"), page.npos) << fit;
  }
  for (const auto& [name, value] : report["environment"].items()) {
    EXPECT_NE(page.find(name), page.npos);
  }
  // Nothing is loaded.
  for (const char* word : {"src=", "<link", "@import", "fetch("}) {
    EXPECT_EQ(file.find(word), file.npos) << word;
  }
}

/// The method that draws only surfaces is measured on the surface, beside the others, and reported
/// there.
TEST_F(Bench, ReportsLinesOfSurfaces) {
  write("R.md", block("lines", "old\n") + block("surfaces", "old\n"));
  ASSERT_EQ(run("bench surface soup --polygons 50,200 --sizes 16 --rounds 1 --threads 1 "
                "--roundoff 1e-9 --methods franklin,perimeter --json s.json -o s.html"),
            0)
      << err_;
  ASSERT_EQ(figures("s.json --readme R.md"), 0) << err_;
  const Json report = json("s.json");
  std::set<std::string> by_perimeter;
  for (const Json& cell : report["line_cells"]) {
    if (cell["method"] != "perimeter") continue;
    EXPECT_TRUE(cell["scene"].get<std::string>().starts_with("surface n=")) << cell;
    by_perimeter.insert(cell["scene"].get<std::string>() + (cell["exact"] ? "" : " rounded"));
    if (cell["exact"]) {
      EXPECT_EQ(cell["missing_length"], 0.0) << cell;
      EXPECT_EQ(cell["extra_length"], 0.0) << cell;
    } else {
      EXPECT_GT(cell["missing_length"].get<double>() + cell["extra_length"].get<double>(), 0.0);
    }
  }
  EXPECT_EQ(by_perimeter.size(), 3u);  // of the larger one the rounded too
  const std::string readme = read(folder_ / "R.md");
  const std::size_t surfaces = readme.find("bench: surfaces");
  EXPECT_EQ(readme.substr(0, surfaces).find("perimeter"), std::string::npos) << readme;
  for (const char* name :
       {"| franklin, exact |", "| perimeter, exact |", "| perimeter, roundoff=1e-9 |"}) {
    EXPECT_NE(readme.find(name, surfaces), readme.npos) << readme;
  }
  const std::string page = shown("s.html", "s.json");
  EXPECT_NE(page.find("Lines of surfaces: below and left is better"), page.npos);
}

/// Methods of lines beside those of surfaces: tables, the page and the README's block have the
/// figures of the JSON; and by themselves, without a picture.
TEST_F(Bench, ReportsMethodsOfLines) {
  write("R.md", block("lines", "old\n"));
  ASSERT_EQ(
      run(kTiny + "--methods z-buffer,franklin,roberts --threads 1,2 --json b.json -o p.html"), 0)
      << err_;
  EXPECT_NE(out_.find("\nline_cells\n"), out_.npos) << out_;
  EXPECT_NE(out_.find("  soup n=24  franklin  exact "), out_.npos) << out_;
  const std::string page = shown("p.html", "b.json");
  const Json report = json("b.json");
  std::set<std::string> seen;
  ASSERT_FALSE(report["line_cells"].empty());
  for (const Json& cell : report["line_cells"]) {
    EXPECT_EQ(cell["scene"].get<std::string>().find("16x16"), std::string::npos) << cell;
    EXPECT_TRUE(seen.insert(cell["scene"].dump() + cell["method"].dump() +
                            cell["precision"].dump() + cell["threads"].dump())
                    .second)
        << cell;
    if (cell["exact"]) {
      EXPECT_EQ(cell["missing_length"], 0.0) << cell;
      EXPECT_EQ(cell["extra_length"], 0.0) << cell;
    }
    const std::size_t start =
        page.find(fmt::format("<summary>lines of {}: ", cell["scene"].get<std::string>()));
    ASSERT_NE(start, page.npos) << cell;
    EXPECT_EQ(numbers_in(row_in(page.substr(start), cell)),
              numbers_of(cell, {"lines", "pieces", "length", "missing_length", "extra_length",
                                "bytes", "exact_stage_calls"}))
        << cell;
  }
  EXPECT_FALSE(report["cells"].empty());
  ASSERT_EQ(figures("b.json --json"), 0) << err_;
  EXPECT_FALSE(Json::parse(out_)["line_fits"].empty());
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  EXPECT_NE(page.find("Hidden lines: below and left is better"), page.npos);
  const std::string readme = read(folder_ / "R.md");
  for (const char* name : {"| franklin, exact |", "| roberts, roundoff=1e-6 |"}) {
    EXPECT_NE(readme.find(name), readme.npos) << readme;
  }

  ASSERT_EQ(run("bench parallel_sheets --methods franklin --rounds 1 --threads 1 --json l.json "
                "-o l.html"),
            0)
      << err_;
  const Json alone = json("l.json");
  EXPECT_FALSE(alone.contains("cells"));
  EXPECT_TRUE(alone["beside"].empty());
  double wrong = 0.0;
  for (const Json& cell : alone["line_cells"]) {
    if (!cell["exact"]) wrong += cell["extra_length"].get<double>();
  }
  EXPECT_GT(wrong, 0.0);
  expect_error("bench soup --methods frnklin -o x.html", "--methods frnklin: no method or peer");
}

/// A line of Markdown in the form of the page.
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
  ASSERT_EQ(run(kTiny + "--threads 1 --json b.json -o p.html"), 0) << err_;
  std::string page = shown("p.html", "b.json");
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  const std::string written = read(folder_ / "R.md");
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
        wrong_of(cell);
    if (cell["method"] == "none" || cell["method"] == "bsp") {
      ASSERT_EQ(cell["wrong_and_tied"], 0) << cell;  // the table would have them in words
    }
  }
  EXPECT_GT(wrong.at("none "), 0);
  EXPECT_NE(written.find(fmt::format("| none | | | | | {} |", wrong.at("none "))), written.npos)
      << written;
  EXPECT_NE(written.find(fmt::format("| bsp | 0 | {} | {} | {} | |", wrong.at("bsp roundoff=1e-12"),
                                     wrong.at("bsp roundoff=1e-9"), wrong.at("bsp roundoff=1e-6"))),
            written.npos)
      << written;
  // Once more: nothing changes.
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  EXPECT_EQ(read(folder_ / "R.md"), written);
}

/// Times are those of ordinary scenes: their errors stand beside them, and those of the scenes that
/// are made to be hard in a column of their own, with the size of their pictures.
TEST_F(Bench, TableOfMethodsHasTheErrorsOfWhatIsTimedAndOfStressScenes) {
  write("R.md", block("methods", ""));
  ASSERT_EQ(run(kTiny + "coplanar_patches --threads 1 --json b.json"), 0) << err_;
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  const Json report = json("b.json");
  std::map<std::string, double> pixels;
  for (const Json& scene : report["scenes"]) pixels[scene["scene"]] = scene["pixels"];
  struct Errors {
    double wrong = 0.0, tied = 0.0, all = 0.0;
  };
  std::map<std::string, Errors> timed, stress;
  for (const Json& cell : report["cells"]) {
    const std::string precision = cell["precision"], scene = cell["scene"];
    const bool is_timed = scene == "soup n=24 24x24";
    const bool is_stress =
        scene.starts_with("cycle_of_3 ") || scene.starts_with("coplanar_patches ");
    if (!is_timed && !is_stress) continue;
    const std::string name =
        cell["method"].get<std::string>() + (precision.empty() ? "" : ", " + precision);
    Errors& error = (is_timed ? timed : stress)[name];
    error.wrong += wrong_of(cell);
    error.tied += cell["wrong_and_tied"].get<double>();
    error.all += pixels.at(scene);
  }
  const std::string written = read(folder_ / "R.md");
  EXPECT_NE(written.find("| method | anew | again | wrong, %: scenes timed | and ties, % | "
                         "wrong, %: stress scenes, 16 x 16 to 24 x 24 | and ties, % | "
                         "bytes a polygon |"),
            written.npos)
      << written;
  int rows = 0, unlike = 0, with_ties = 0;
  std::istringstream lines(written);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ") || line.starts_with("| method |")) continue;
    const std::vector<std::string> row = fields(on_page(line));
    const auto percent = [&](double count, double all) {
      return fmt::format("{:.3g}", up(100.0 * count / all));
    };
    const Errors &of_timed = timed.at(row.at(0)), &of_stress = stress.at(row.at(0));
    EXPECT_EQ(row.at(3), percent(of_timed.wrong, of_timed.all)) << line;
    EXPECT_EQ(row.at(4), percent(of_timed.tied, of_timed.all)) << line;
    EXPECT_EQ(row.at(5), percent(of_stress.wrong, of_stress.all)) << line;
    EXPECT_EQ(row.at(6), percent(of_stress.tied, of_stress.all)) << line;
    ++rows;
    unlike += row.at(3) != row.at(5);
    with_ties += row.at(6) != "0";
  }
  EXPECT_GE(rows, 13);
  EXPECT_GT(unlike, 3);
  EXPECT_GT(with_ties, 0);
  EXPECT_NE(written.find("\n| plain-z-buffer, double |"), written.npos) << written;

  // Without stress scenes there is no column of them; with one size, the column is of that size.
  ASSERT_EQ(
      run("bench soup --polygons 24 --sizes 16 --rounds 1 --threads 1 --methods z-buffer,none "
          "--json a.json"),
      0)
      << err_;
  ASSERT_EQ(figures("a.json --readme R.md"), 0) << err_;
  EXPECT_NE(
      read(folder_ / "R.md").find("| wrong, %: scenes timed | and ties, % | bytes a polygon |"),
      std::string::npos);
  ASSERT_EQ(run("bench soup cycle_of_3 --polygons 24 --sizes 16 --rounds 1 --threads 1 "
                "--methods z-buffer,none --json c.json"),
            0)
      << err_;
  ASSERT_EQ(figures("c.json --readme R.md"), 0) << err_;
  EXPECT_NE(read(folder_ / "R.md").find("| wrong, %: stress scenes, 16 x 16 | and ties, % |"),
            std::string::npos);
}

/// The comparisons of a report, by scene, threads, peer and task.
std::map<std::string, Json> compared(const Json& report) {
  std::map<std::string, Json> all;
  for (const Json& beside : report["beside"]) {
    all[fmt::format("{}/{}/{}/{}", beside["scene"].get<std::string>(), beside["threads"].get<int>(),
                    beside["other"].get<std::string>(), beside["what"].get<std::string>())] =
        beside;
  }
  return all;
}

/// A row of the table of new views, from the JSON.
std::string row_of_new_views(const Json& report, const Json& growth_of_new_views,
                             const std::string& name, const std::string& scene,
                             const std::string& triangles, bool is_last) {
  auto all = compared(report);
  std::string row = fmt::format("| {} | {} | 48 x 48 |", name, triangles);
  for (const int threads : {1, 2}) {
    const Json& found = all[fmt::format("{}/{}/OSMesa/moving camera", scene, threads)];
    if (!found.contains("times_faster")) {
      row += " |";
      continue;
    }
    const Json& times = found["times_faster"];
    row += fmt::format(" {} ({} to {}) |", in_table(times["median"]), in_table(times["least"]),
                       in_table(times["greatest"]));
  }
  row += " 0 in 16 pictures |";
  for (const char* what : {"retained scene", "view", "drawing"}) {
    const std::string key = fmt::format("{}/1/bytes a triangle/{}", scene, what);
    row += fmt::format(" {:.0f} |", up(all.at(key)["count"]));
  }
  for (const int threads : {1, 2}) {
    std::string exponent;
    for (const Json& growth : growth_of_new_views) {
      if (growth["scene"] == name && growth["threads"] == threads) {
        exponent = growth["exponent"].dump();
      }
    }
    row += is_last && !exponent.empty() ? fmt::format(" {} |", exponent) : " |";
  }
  return row;
}

/// Every view is correct, and all outputs agree. A closed mesh has its back faces removed, and its
/// squares are cut.
TEST_F(Bench, HoldsNewViewsOfRetainedScenesAgainstOsmesaAndTheTruth) {
  write("cube.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  write("R.md", block("moving-camera", "stale\n"));
  ASSERT_EQ(run("bench --moving-camera terrain cube.obj --polygons 24,96 --sizes 48 --rounds 1 "
                "--threads 1,2 --json b.json -o p.html"),
            0)
      << err_;
  EXPECT_NE(out_.find("\nbeside\n"), out_.npos) << out_;
  EXPECT_EQ(out_.find("\ncells\n"), out_.npos) << out_;
  const Json report = json("b.json");
  EXPECT_FALSE(report.contains("cells"));
  EXPECT_FALSE(report.contains("viewing"));
  ASSERT_EQ(figures("b.json --json"), 0) << err_;
  const Json growth_of_views = Json::parse(out_)["growth_of_new_views"];
  auto all = compared(report);
  const std::vector<std::pair<std::string, int>> scenes{
      {"terrain n=24 48x48", 18}, {"terrain n=96 48x48", 72}, {"cube.obj 48x48", 12}};
  for (const auto& [scene, triangles] : scenes) {
    for (const int threads : {1, 2}) {
      const std::string of = fmt::format("{}/{}/", scene, threads);
      EXPECT_EQ(all[of + "OSMesa/triangles"]["count"], triangles) << of;
      EXPECT_EQ(all[of + "truth/views"]["count"], 8) << of;
      EXPECT_EQ(all[of + "truth/wrong pixels"]["count"], 0) << of;
      const Json& others = all[of + "OSMesa/pixels that differ, %"];
      if (others.contains("count")) {
        EXPECT_LT(others["count"], 3.0) << of;
      }
      for (const char* what : {"retained scene", "view", "drawing"}) {
        EXPECT_GT(all[of + "bytes a triangle/" + what]["count"], 0) << of << what;
      }
    }
  }
  // The least squares through two points are the line through them.
  ASSERT_EQ(growth_of_views.size(), 2u);
  for (const Json& growth : growth_of_views) {
    EXPECT_EQ(growth["scene"], "terrain");
    EXPECT_EQ(growth["points"], 2);
    const Json& beside_first = all.at(fmt::format(
        "terrain n=96 48x48/{}/fewest polygons/moving camera", growth["threads"].get<int>()));
    const double cost = 1.0 / beside_first["times_faster"]["median"].get<double>();
    EXPECT_NEAR(growth["exponent"], std::log(cost) / std::log(72.0 / 18.0), 0.01);
  }
  std::string page = shown("p.html", "b.json");
  constexpr std::string_view kToTheLeft = " class='l'";
  for (std::size_t at = 0; (at = page.find(kToTheLeft, at)) != page.npos;) {
    page.erase(at, kToTheLeft.size());
  }
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  const std::string written = read(folder_ / "R.md");
  EXPECT_EQ(written.find("stale"), written.npos);
  for (const std::string& row :
       {row_of_new_views(report, growth_of_views, "terrain", "terrain n=24 48x48", "18", false),
        row_of_new_views(report, growth_of_views, "terrain", "terrain n=96 48x48", "72", true),
        row_of_new_views(report, growth_of_views, "cube", "cube.obj 48x48", "12", true)}) {
    EXPECT_NE(written.find(row + '\n'), written.npos) << row << '\n' << written;
    EXPECT_NE(page.find(on_page(row)), page.npos) << on_page(row);
  }
}

/// The front names the methods that no other equals in both speed and accuracy; errors are all
/// wrong pixels.
void expect_front(const std::string& written, const std::map<std::string, double>& times,
                  const std::map<std::string, std::pair<double, double>>& errors) {
  for (const auto& timed : times) {
    const auto& name = timed.first;
    const double time = timed.second;
    const auto error_of = [&](const std::string& of) {
      return errors.at(of).first / errors.at(of).second;
    };
    const auto as_good = [&](const auto& other) {
      return other.first != name && other.second <= time && error_of(other.first) <= error_of(name);
    };
    const auto equal = [&](const auto& other) {
      return as_good(other) && other.second == time && error_of(other.first) == error_of(name);
    };
    if (std::ranges::any_of(times, equal)) continue;  // Either may stand for both.
    const bool beaten = std::ranges::any_of(times, as_good);
    const bool on_front =
        written.find(fmt::format(" {} (time {:.3g}, ", name, up(time))) != written.npos;
    EXPECT_EQ(on_front, !beaten) << name << '\n' << written;
  }
}

/// The page begins with the plot of all, which is a file of its own too; its front follows from the
/// cells.
TEST_F(Bench, ThePageBeginsWithSpeedAgainstErrorOfAll) {
  write("R.md", block("front", ""));
  ASSERT_EQ(run(kTiny + "--threads 1 --json b.json -o p.html"), 0) << err_;
  const std::string page = shown("p.html", "b.json");
  ASSERT_EQ(figures("b.json --plot front.svg"), 0) << err_;
  const std::string plot = read(folder_ / "front.svg");
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  EXPECT_LT(page.find("<svg"), page.find("<table"));
  EXPECT_LT(page.find("<table"), page.find("<h2>Error against time"));
  EXPECT_TRUE(plot.starts_with("<svg xmlns='http://www.w3.org/2000/svg'")) << plot.substr(0, 99);
  std::map<std::string, double> times;  // of the scene with the most polygons
  // Wrong pixels and all of them: of that scene, and of the hard cases.
  std::map<std::string, std::pair<double, double>> timed_errors, stress_errors;
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
    if (scene != largest && !scene.starts_with("cycle_of_3")) continue;
    auto& error = (scene == largest ? timed_errors : stress_errors)[name];
    error.first += wrong_of(cell);
    error.second += pixels[scene];
  }
  ASSERT_GT(times.size(), 20u);
  const std::string written = read(folder_ / "R.md");
  EXPECT_NE(plot.find("stress scenes, 16 x 16 to 24 x 24, %</text>"), plot.npos);
  EXPECT_NE(plot.find(">plain-z-buffer, double</text>"), plot.npos);
  // One front by either error, or two.
  const std::size_t second = written.find("By those of the stress scenes: ");
  expect_front(written.substr(0, second), times, timed_errors);
  expect_front(second == written.npos ? written : written.substr(second), times, stress_errors);
}

/// A sort that would take too long is reported as skipped, with the reason, and nothing is advised
/// from its scene. The omission is certain on any machine: the sort of 20 planes is measured in any
/// case, that of 200 would take a hundred times as long, and a mesh has one size only.
TEST_F(Bench, SaysWhatWasSkippedAndAdvisesNothingFromIt) {
  write("R.md", block("exactness", "") + block("advice", ""));
  write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\n");
  ASSERT_EQ(run("bench planes m.obj --polygons 10,20,200 --sizes 32 --rounds 1 --threads 1 "
                "--seconds 0.001 --methods z-buffer,depth-sort --roundoff none --json b.json"),
            0)
      << err_;
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  const std::string written = read(folder_ / "R.md");
  std::set<std::string> skipped;  // scenes on which an exact method was
  const Json report = json("b.json");
  for (const Json& cell : report["cells"]) {
    if (cell["exact"].get<bool>() && cell.contains("skipped")) {
      skipped.insert(cell["scene"].get<std::string>());
    }
  }
  EXPECT_EQ(skipped, std::set<std::string>{"planes n=200 32x32"}) << written;
  EXPECT_NE(written.find(" Skipped: depth-sort: planes n=200 32x32, it would take too long, from "
                         "what a smaller one took."),
            written.npos)
      << written;
  EXPECT_NE(written.find("over 1 scene (1 more, from which an exact method was left out, do not"),
            written.npos)
      << written;
}

/// One scene is measured, so that each method's time is its median.
TEST_F(Bench, AdvisesTheFirstOfTheMethodsThatNoneIsClearlyFasterThan) {
  write("R.md", block("advice", ""));
  ASSERT_EQ(run("bench soup --polygons 24 --sizes 24 --roundoff none --threads 1 --rounds 3 "
                "--json b.json"),
            0)
      << err_;
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
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

}  // namespace
}  // namespace displayfile::test
