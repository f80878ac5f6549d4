// The dated page of figures (tests/bench/figures), of tiny scenes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/bench_fixture.h"

namespace displayfile::test {
namespace {

/// The script of the dated page, on tiny scenes.
class PageOfFigures : public Bench {
 protected:
  int make_page(const std::string& arguments) {
    const fs::path build = fs::path(DISPLAYFILE_COMMAND).parent_path().parent_path();
    const std::string line =
        fmt::format("cd '{}' && '{}/tests/bench/figures' --tiny --build '{}' {} >.out 2>.err",
                    folder_.string(), DISPLAYFILE_SOURCE_DIR, build.string(), arguments);
    const int status = std::system(line.c_str());
    out_ = read(folder_ / ".out");
    err_ = read(folder_ / ".err");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

/// The date, the measured version and the machine; both errors, every precision, and slower rows.
TEST_F(PageOfFigures, IsMadeByOneCommand) {
  ASSERT_EQ(make_page("-o page"), 0) << err_ << out_;
  const std::string page = read(folder_ / "page/figures.md");
  const Json report = json("page/report.json");
  const Json& environment = report["environment"];
  const std::string date = environment["date"];
  EXPECT_EQ(date.size(), std::string_view("2026-01-01").size());
  EXPECT_TRUE(page.starts_with("# Figures of " + date + "\n")) << page.substr(0, 99);
  EXPECT_NE(page.find("these figures mean nothing"), page.npos);
  for (const char* name : {"commit", "compiler", "build type", "flags", "processor", "OSMesa"}) {
    const std::string row = fmt::format("| {} | {} |", name, environment[name].get<std::string>());
    EXPECT_NE(page.find(row), page.npos) << row;
  }
  EXPECT_NE(environment["commands"].get<std::string>().find("displayfile bench soup"), page.npos);
  EXPECT_EQ(environment["commands"].get<std::string>().find('/'), page.npos) << "a folder's name";
  EXPECT_NE(
      page.find("| and ties, % | wrong, %: stress scenes, 16 x 16 to 24 x 24 | and ties, % |"),
      page.npos);
  std::set<std::string> columns;
  for (const Json& cell : report["cells"]) {
    const std::string precision = cell["precision"];
    columns.insert(cell["method"].get<std::string>() + (precision.empty() ? "" : ", " + precision));
  }
  const std::size_t all = page.find("<!-- bench: all-methods -->");
  ASSERT_NE(all, page.npos);
  const std::string methods = page.substr(all, page.find("<!-- bench: end -->", all) - all);
  for (const std::string& column : columns) {
    EXPECT_NE(methods.find("\n| " + column + " | "), methods.npos) << column;
  }
  // A single scene is counted by its ratio: below 1 or not.
  for (const Json& beside : report["beside"]) {
    if (beside["other"] != "gl2ps, best root" || beside["what"] != "depth-sort") continue;
    const double ratio = beside["times_faster"]["median"];
    const std::string row =
        fmt::format("| depth-sort, exact | gl2ps, best root | 1 | {} of 1 |", ratio < 1.0 ? 1 : 0);
    EXPECT_NE(page.find(row), page.npos) << row;
  }
  if (columns.contains("osmesa, 24 bits")) {  // the README's reasons are beside it
    write("R.md", block("reasons", ""));
    ASSERT_EQ(figures("page/report.json --readme R.md"), 0) << err_;
    const std::string reasons = read(folder_ / "R.md");
    EXPECT_NE(
        reasons.find("\n1. **Exact.** Pixels that show the wrong polygon: on ordinary scenes 0 %, "
                     "by OSMesa "),
        reasons.npos)
        << reasons;
    EXPECT_NE(reasons.find(" 16 x 16 to 24 x 24 pixels, made so that rounding decides, 0 % and "),
              reasons.npos);
    EXPECT_NE(reasons.find("**Fast without a GPU.** The exact z-buffer takes "), reasons.npos);
    EXPECT_EQ(page.find("**Exact.**"), page.npos);
  }
  EXPECT_TRUE(read(folder_ / "page/speed_and_error.svg").starts_with("<svg"));
  EXPECT_TRUE(fs::exists(folder_ / "page/report.html"));
}

/// The parts that the script adds to a report: rows of other programs, and the meshes.
TEST_F(PageOfFigures, HasTheRowsOfOtherPrograms) {
  write("R.md", block("map-and-sorts", "") + block("sheets", "") + block("slower", "") +
                    block("map-cost", "") + block("meshes", ""));
  ASSERT_EQ(run("bench soup --polygons 9 --sizes 8 --rounds 1 --threads 1 --methods none "
                "--json b.json"),
            0)
      << err_;
  Json report = json("b.json");
  const auto of_map = [](const char* scene, const char* way, int pieces, double time) {
    Json row{{"scene", scene}, {"polygons", 1200}, {"way", way}, {"pieces", pieces}};
    if (time > 0.0) row["time"] = {{"median", time}, {"least", time / 2}, {"greatest", 2 * time}};
    return row;
  };
  report["map_rows"] = {of_map("planes", "map", 22, 0), of_map("village", "map", 900, 0),
                        of_map("planes", "depth-sort, written", 1839, 8),
                        of_map("village", "depth-sort, written", 700, 0.5)};
  report["sheet_rows"] = {{{"work", "surface 40 x 40"},
                           {"measured", "0.8"},
                           {"beside", "gnuplot"},
                           {"threads", "all"},
                           {"times_faster", 0.8}},
                          {{"work", "few lines"},
                           {"asked", ">= 10"},
                           {"measured", "12"},
                           {"beside", "another"},
                           {"holds", true}}};
  report["meshes"] = {{{"name", "a.obj"}, {"source", "there"}, {"sha256", "12ab"}}};
  write("b.json", report.dump());
  ASSERT_EQ(figures("b.json --readme R.md"), 0) << err_;
  const std::string written = read(folder_ / "R.md");
  for (const char* row :
       {"| planes | 1,200 | 22 | 1,839 | 8.0 (4.0 to 16) |",
        "| village | 1,200 | 900 | 700 | 0.50 (0.25 to 1.0) |",
        "| map, exact | our own depth-sort, written | 1 | 1 of 2 | 0.50 | 2.0 | 8.0 | village 0.50 "
        "|",
        "| surface 40 x 40 | gnuplot | all | 1 of 1 | 0.80 | 0.80 | 0.80 | surface 40 x 40 0.80 |",
        "| surface 40 x 40 | | 0.8 | | gnuplot | |", "| few lines | >= 10 | 12 | | another | yes |",
        "1,200 crossing planes become 22 visible pieces; depth sort cuts them into 1,839. But on 1 "
        "of 2 scenes they take 2.0 to 2.0 times as long to find as depth sort takes with writing, "
        "and village has 1.3 times as many.",
        "| a.obj | there | 12ab |"}) {
    EXPECT_NE(written.find(row), written.npos) << row << '\n' << written;
  }
}

TEST_F(PageOfFigures, RefusesOtherMeshes) {
  fs::create_directory(folder_ / "meshes");
  write("meshes/cow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(make_page("meshes -o page"), 2);
  EXPECT_NE(err_.find("meshes/cow.obj: another file: expected SHA-256 69afce54"), err_.npos)
      << err_;
  EXPECT_NE(err_.find("meshes/spot.obj: is not there"), err_.npos) << err_;
  EXPECT_FALSE(fs::exists(folder_ / "page"));
  EXPECT_EQ(make_page("--write"), 2);
  EXPECT_NE(err_.find("they are not for --write"), err_.npos) << err_;
}

}  // namespace
}  // namespace displayfile::test
