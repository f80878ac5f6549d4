#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command_fixture.h"

/// The common part of the tests of `displayfile bench`.
namespace displayfile::test {

using Json = nlohmann::ordered_json;

inline const std::string kTiny = "bench soup cycle_of_3 --polygons 12,24 --sizes 16,24 --rounds 1 ";

class Bench : public Command {
 protected:
  Json json(const std::string& name) { return Json::parse(read(folder_ / name)); }

  /// Runs report-figures in the test's folder, as run does the command.
  int figures(const std::string& arguments) {
    const std::string line = "cd '" + folder_.string() +
                             "' && node '" DISPLAYFILE_SOURCE_DIR
                             "/tests/bench/command/report-figures' " +
                             arguments + " >.out 2>.err";
    const int status = std::system(line.c_str());
    out_ = read(folder_ / ".out");
    err_ = read(folder_ / ".err");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// The text of a report's page, made by the page's own scripts.
  std::string shown(const std::string& page, const std::string& report) {
    const std::string text = read(folder_ / page);
    const std::string begin = "<script type='application/json' id='report'>";
    const std::size_t start = text.find(begin) + begin.size();
    EXPECT_EQ(Json::parse(text.substr(start, text.find("</script>", start) - start)), json(report));
    for (const char* script : {"figures", "summaries", "plot", "page"}) {
      const std::string source = read(fs::path(DISPLAYFILE_SOURCE_DIR) /
                                      "tests/bench/command/page" / (script + std::string(".js")));
      EXPECT_NE(text.find(source), text.npos) << script;
    }
    EXPECT_EQ(figures(report + " --page"), 0) << err_;
    return out_;
  }
};

/// Wrong pixels without the ties, which are counted apart.
inline int wrong_of(const Json& cell) {
  return cell["wrong_pixels"].get<int>() - cell["wrong_and_tied"].get<int>();
}

/// The parts of a report that do not depend on time.
inline Json counts(Json report) {
  report["environment"].erase("date");
  for (Json& beside : report["beside"]) beside.erase("times_faster");
  for (Json& scene : report["scenes"]) {
    scene.erase("reference_growth");
    scene.erase("line_reference_growth");
  }
  for (const char* cells : {"cells", "line_cells"}) {
    for (Json& cell : report[cells]) {
      cell.erase("time");
      cell.erase("time_again");
      if (cell["threads"] != 1) cell.erase("bytes");  // the division of work among threads varies
    }
  }
  return report;
}

/// The fields of a row of a table in HTML.
inline std::vector<std::string> fields(const std::string& row) {
  std::vector<std::string> texts;
  for (std::size_t at = row.find("<td"); at != row.npos;) {
    const std::size_t start = row.find('>', at) + 1;
    at = row.find("<td", start);
    texts.push_back(row.substr(start, at == row.npos ? at : at - start));
  }
  return texts;
}

/// A number that lies halfway between two decimals, as binary fractions of few digits do, made the
/// least bit larger: JavaScript rounds such a half away from zero, the formatting here to even. Any
/// other number is rounded alike by both and is left as it is.
inline double up(double value) {
  const bool may_be_half = value * 1024.0 == std::floor(value * 1024.0);
  return value == 0.0 || !may_be_half ? value : std::nextafter(value, 1e300);
}

/// A ratio in the form of the tables.
inline std::string in_table(double ratio) {
  return fmt::format("{:.{}f}", up(ratio), ratio < 1.0 ? 2 : ratio < 9.95 ? 1 : 0);
}

/// A block of a README, marked.
inline std::string block(const std::string& name, const std::string& text) {
  return fmt::format("<!-- bench: {} -->\n{}<!-- bench: end -->\n", name, text);
}

}  // namespace displayfile::test
