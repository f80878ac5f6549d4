#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command_fixture.h"

/// What the tests of `displayfile bench` have in common.
namespace displayfile::test {

using Json = nlohmann::ordered_json;

inline const std::string kTiny = "bench soup cycle_of_3 --polygons 12,24 --sizes 16,24 --rounds 1 ";

class Bench : public Command {
 protected:
  Json json(const std::string& name) { return Json::parse(read(folder_ / name)); }
};

/// What does not hang on time.
inline Json counts(Json report) {
  for (Json& beside : report["beside"]) beside.erase("times_faster");
  report.erase("fits");
  report.erase("growth_of_new_views");
  report.erase("auto");
  report.erase("line_fits");
  for (Json& scene : report["scenes"]) {
    scene.erase("reference_growth");
    scene.erase("line_reference_growth");
  }
  for (const char* cells : {"cells", "line_cells"}) {
    for (Json& cell : report[cells]) {
      cell.erase("time");
      cell.erase("time_again");
      if (cell["threads"] != 1) cell.erase("bytes");  // threads share out the work as it comes
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

/// A block of a README, marked.
inline std::string block(const std::string& name, const std::string& text) {
  return fmt::format("<!-- bench: {} -->\n{}<!-- bench: end -->\n", name, text);
}

}  // namespace displayfile::test
