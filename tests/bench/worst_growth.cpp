// The worst growth of each operation, with the input that causes it (worst_growth.md):
//   worst_growth [--only WORD] [--doublings N] [--seconds S]
// Sizes are doubled until a run takes S seconds. Prints a table in Markdown: ratios and counts.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "clip/error.h"
#include "programs/bench/growth.h"
#include "tests/bench/command_line.h"
#include "tests/bench/result_table.h"
#include "tests/bench/worst_inputs.h"

namespace displayfile::bench {
namespace {

struct Options {
  std::string only;
  int doublings = 5;
  double most_seconds = 1.0;
};

/// Shorter runs tell little: sizes from which a run takes so long are fitted, three at least.
constexpr double kShort = 0.001;
constexpr int kRounds = 3;
/// A power is worse than another if it is larger by more than what a logarithm or caches add.
constexpr double kTolerance = 0.3;

Cost least(const WorstCase& worst, std::size_t n) {
  Cost cost = worst.run(n);
  for (int round = 1; round < kRounds && cost.seconds < 0.1; ++round) {
    cost.seconds = std::min(cost.seconds, worst.run(n).seconds);
  }
  return cost;
}

std::vector<std::string> measured(const WorstCase& worst, const Options& options) {
  std::vector<double> sizes, seconds, outputs;
  std::string refused;
  for (std::size_t n = worst.smallest; sizes.size() <= static_cast<std::size_t>(options.doublings);
       n *= 2) {
    Cost cost{};
    try {
      cost = least(worst, n);
    } catch (const Error& error) {  // a limit: of pieces, of memory
      if (sizes.empty()) throw;
      refused = fmt::format("; {} are refused: {}", n, error.what());
      break;
    }
    sizes.push_back(static_cast<double>(n));
    seconds.push_back(std::max(cost.seconds, 1e-9));
    outputs.push_back(std::max(cost.output, 1.0));
    if (cost.seconds > options.most_seconds) break;
  }
  std::size_t first = 0;
  while (first + 3 < sizes.size() && seconds[first] < kShort) ++first;
  const auto exponent = [&](const std::vector<double>& costs) {
    if (sizes.size() < 2) return 0.0;
    return fitted_exponent(std::span(sizes).subspan(first), std::span(costs).subspan(first));
  };
  const double of_time = exponent(seconds), of_output = exponent(outputs);
  const bool follows = of_time <= std::max(1.0, of_output) + kTolerance;
  return {std::string(worst.operation),
          std::string(worst.input),
          fmt::format("{:.0f} to {:.0f}", sizes.front(), sizes.back()),
          fmt::format("{:.3g}", seconds.back() / seconds.front()),
          fmt::format("{:.2f}", of_time),
          fmt::format("{:.3g} {}", outputs.back(), worst.output),
          fmt::format("{:.2f}", of_output),
          follows ? "" : "faster",
          std::string(worst.bound) + refused};
}

void run(const Options& options) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& cases : {worst_of_files(), worst_of_pictures()}) {
    for (const WorstCase& worst : cases) {
      const std::string name = fmt::format("{}, {}", worst.operation, worst.input);
      if (name.find(options.only) == std::string::npos) continue;
      fmt::print(stderr, "{}\n", name);
      try {
        rows.push_back(measured(worst, options));
      } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", name, error.what()));
      }
    }
  }
  fmt::print("{}", text_table({"operation", "input", "n", "time, of the smallest", "exponent",
                               "output of the largest", "exponent", "than output", "bounded by"},
                              rows));
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app{"the worst growth of each operation", "worst_growth"};
  app.add_option("--only", options.only, "operations and inputs that have this in their names");
  app.add_option("--doublings", options.doublings)->check(CLI::Range(1, 30));
  app.add_option("--seconds", options.most_seconds, "no larger n after a run that took longer")
      ->check(CLI::PositiveNumber);
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run(options); });
}
