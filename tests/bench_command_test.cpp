// `displayfile bench` as a command: interrupted runs, help, refused options.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "tests/bench_fixture.h"

namespace displayfile::test {
namespace {

/// Runs the command and ends it when the partial file has `lines` lines.
void interrupt(const fs::path& folder, const std::string& arguments, int lines) {
  const std::string line = fmt::format(
      "cd '{}'; '{}' {} >.out 2>.err & run=$!; until [ ! -d /proc/$run ] || "
      "[ \"$(cat report.html.partial 2>.err | wc -l)\" -ge {} ]; do :; done; "
      "kill -9 $run; wait $run",
      folder.string(), DISPLAYFILE_COMMAND, arguments, lines);
  EXPECT_NE(std::system(line.c_str()), 0) << "it was faster than the interruption";
}

TEST_F(Bench, AnInterruptedRunGoesOn) {
  const std::string bench = kTiny + "--threads 1 --json b.json";
  ASSERT_EQ(run(bench), 0) << err_;
  const Json whole = json("b.json");
  fs::remove(folder_ / "b.json");
  fs::remove(folder_ / "report.html");
  interrupt(folder_, bench, 12);
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
  // Figures measured before the interruption are reported.
  const std::size_t second = kept.find('\n') + 1;
  const Json first = Json::parse(kept.substr(second, kept.find('\n', second) - second));
  EXPECT_EQ(json("b.json")["cells"][0], first["figures"]);
}

TEST_F(Bench, AnotherBuildsFiguresAreNotTakenOver) {
  write("report.html.partial", "{\"displayfile_bench\":2,\"of\":\"another\"}\nnonsense\n");
  ASSERT_EQ(run(kTiny + "--methods none --threads 1"), 0) << err_;
  EXPECT_NE(out_.find(" 0 taken over"), out_.npos) << out_;
}

/// The program that measures is beside the command; a command without it reports that.
TEST_F(Bench, SaysThatItsProgramIsNotThere) {
  fs::copy_file(DISPLAYFILE_COMMAND, folder_ / "alone");
  const std::string line = "cd '" + folder_.string() + "' && ./alone bench soup >.out 2>.err";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 2);
  const std::string message = read(folder_ / ".err");
  EXPECT_NE(message.find("displayfile-bench cannot be started"), message.npos) << message;
  EXPECT_NE(message.find("neither is there"), message.npos) << message;
}

/// Wherever the command's own parser ends, the program's describes its arguments. The seed applies
/// to all generated scenes, including the city of the walk.
TEST_F(Bench, TheSeedIsThatOfTheWalk) {
  ASSERT_EQ(run("bench walk --polygons 60 --sizes 16 --rounds 1 --seed 2 --json b.json"), 0)
      << err_;
  const Json scenes = json("b.json")["scenes"];
  ASSERT_EQ(scenes.size(), 1u);
  EXPECT_NE(scenes[0]["scene"].get<std::string>().find("seed=2"), std::string::npos);
}

TEST_F(Bench, HelpIsThatOfTheProgram) {
  for (const char* line : {"bench --help", "bench -h", "--help bench", "bench soup --help"}) {
    ASSERT_EQ(run(line), 0) << line;
    EXPECT_NE(out_.find("Usage: displayfile bench [OPTIONS] [SCENE...]"), out_.npos) << out_;
    EXPECT_NE(out_.find("--moving-camera"), out_.npos) << out_;
  }
  ASSERT_EQ(run("--help"), 0);
  EXPECT_NE(out_.find("Speed against error of every method"), out_.npos) << out_;
}

TEST_F(Bench, Refuses) {
  expect_error("bench nowhere", "nowhere: no such scene or file");
  expect_error("bench --moving-camera walk cycle_of_3", "--moving-camera: no scene for it");
  EXPECT_EQ(run("bench --moving-camera soup --methods bsp"), 2);
  EXPECT_NE(err_.find("--methods excludes --moving-camera"), err_.npos) << err_;
  expect_error("bench soup -o nowhere/r.html", "nowhere/r.html");
  expect_error("bench soup -o r.png", "r.png: expected a file that ends in .html");
  expect_error("bench soup --polygons 0", "displayfile: --polygons: ");
  expect_error("bench soup --polygon 5", "displayfile: ");
  expect_error("bench soup --json nowhere/r.json", "nowhere/r.json");
  expect_error("bench soup --methods robert", "robert: no method or peer: expected some of none");
  expect_error("bench soup --methods plain-scan-line",
               "plain-scan-line: a method that is not measured: expected some of none");
  expect_error("bench soup --roundoff 2", "roundoff");
  write("bad.draw", "open-segment 1\npolygon-abs-3 0 0 0  1 0 0\nclose-segment\n");
  expect_error("bench bad.draw", "bad.draw:2:");
  expect_error("bench soup -o r.html --json ./r.html", "r.html and ./r.html: two outputs are one");
  EXPECT_EQ(run("bench soup --seconds nan"), 2);
  EXPECT_NE(err_.find("--seconds: nan: expected a number, 0.001 to"), err_.npos) << err_;
  EXPECT_EQ(run("bench soup --json ''"), 2);
  EXPECT_NE(err_.find("--json: is empty: expected FIGURES.json"), err_.npos) << err_;
  EXPECT_EQ(run("bench soup --sizes 0"), 2);
  EXPECT_EQ(run("bench soup --threads none"), 2);
}

/// Only the chosen sorts are compared with those of gl2ps.
TEST_F(Bench, ComparesWithGl2psTheChosenSorts) {
  const std::string planes =
      "bench planes --polygons 12 --sizes 16 --rounds 1 --threads 1 --roundoff none "
      "--json b.json --methods ";
  ASSERT_EQ(run(planes + "z-buffer,gl2ps"), 0) << err_;
  const Json report = json("b.json");
  if (report["environment"]["gl2ps"] == "not in this build") return;
  bool has_gl2ps = false;
  for (const Json& row : report["beside"]) {
    has_gl2ps = has_gl2ps || row["other"] == "gl2ps";
    for (const char* sort : {"bsp", "depth-sort", "map"}) {
      EXPECT_NE(row["other"], sort) << row;
      EXPECT_NE(row["what"], sort) << row;
    }
  }
  EXPECT_TRUE(has_gl2ps);
  ASSERT_EQ(run(planes + "map,gl2ps -o two.html"), 0) << err_;
  std::set<std::string> beside;
  const Json with_map = json("b.json");
  for (const Json& row : with_map["beside"]) {
    if (row["other"] == "gl2ps") beside.insert(row["what"]);
  }
  EXPECT_EQ(beside, (std::set<std::string>{"triangles", "pieces a triangle", "map"}));
  EXPECT_FALSE(shown("two.html", "b.json").empty());
}

/// A method that makes more pieces than are allowed is skipped, and the rest is measured.
TEST_F(Bench, SkipsWhatExceedsALimitOfPieces) {
  ASSERT_EQ(run("bench planes --polygons 40 --sizes 16 --rounds 1 --threads 1 --roundoff 1e-9 "
                "--methods z-buffer,bsp,scan-line,gl2ps --limit-pieces 100 --json b.json "
                "-o limited.html"),
            0)
      << err_;
  const Json report = json("b.json");
  const std::string too_many = "cuts polygons into more than 100 pieces";
  int skipped = 0, measured = 0;
  for (const Json& cell : report["cells"]) {
    if (cell["method"] == "bsp") {
      ASSERT_TRUE(cell.contains("skipped")) << cell;
      EXPECT_NE(cell["skipped"].get<std::string>().find(too_many), std::string::npos) << cell;
      ++skipped;
    } else if (cell["method"] != "gl2ps") {
      EXPECT_TRUE(cell.contains("time")) << cell;
      ++measured;
    }
  }
  EXPECT_EQ(skipped, 2);
  EXPECT_EQ(measured, 4);
  EXPECT_NE(out_.find(too_many), std::string::npos) << out_;
  for (const Json& row : report["beside"]) {
    if (row["what"] != "bsp" && row["other"] != "bsp") continue;
    ASSERT_TRUE(row.contains("left_out")) << row;
    EXPECT_NE(row["left_out"].get<std::string>().find(too_many), std::string::npos) << row;
  }
  EXPECT_FALSE(shown("limited.html", "b.json").empty());
}

/// The limit for the whole command is not a limit of one method.
TEST_F(Bench, EndsWhereItsTimeIsOver) {
  EXPECT_EQ(run("bench planes --polygons 400 --sizes 256 --methods bsp --limit-seconds 0.05"), 2);
  EXPECT_FALSE(fs::exists(folder_ / "report.html"));
}

}  // namespace
}  // namespace displayfile::test
