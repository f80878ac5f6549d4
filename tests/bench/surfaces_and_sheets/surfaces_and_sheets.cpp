// Mathematical surfaces, and sheets of drawings: speed beside other programs, and error, in one
// table.
//   surfaces_and_sheets [MESH...] [--rounds 3] [--grids 200] [--size 500] [--most 2000]
// Prints ratios, an exponent and lengths. Of the meshes the sheet is drawn, and those that are
// closed are cut.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "tests/bench/command_line.h"
#include "tests/bench/surfaces_and_sheets/rows.h"

namespace displayfile::bench {

Cost least_cost(const std::vector<std::string>& command, int rounds) {
  Cost least = cost_of(command);
  for (int k = 1; k < rounds; ++k) {
    const Cost cost = cost_of(command);
    least.wall = std::min(least.wall, cost.wall);
    least.processor = std::min(least.processor, cost.processor);
  }
  return least;
}

namespace {

void run_table(const TableOptions& options) {
  std::vector<Result> results;
  add_surface_rows(options, results);
  add_sheet_rows(options, results);
  add_section_rows(options, results);
  fmt::print("{}", text_table(results));
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::TableOptions options;
  CLI::App app("Surfaces and sheets beside other programs and the truth", "surfaces_and_sheets");
  app.add_option("meshes", options.meshes, "meshes for sheets and sections")
      ->check(CLI::ExistingFile);
  app.add_option("--rounds", options.rounds)->check(CLI::Range(1, 100));
  app.add_option("--grids", options.grids, "random grids")->check(CLI::Range(1, 100'000));
  app.add_option("--size", options.size, "points each way beside gnuplot")
      ->check(CLI::Range(10, 5'000));
  app.add_option("--most", options.most, "points each way of growth")
      ->check(CLI::Range(100, 10'000));
  app.add_option("--limit", options.limit, "seconds that OpenCASCADE may take for a view");
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run_table(options); });
}
