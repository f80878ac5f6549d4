// Hidden lines: exact against roundoff, Roberts and Appel against Franklin, threads, and how time
// grows with the scene.
//   hidden_lines_bench [MESH...]
// Prints ratios and counts; run it on a machine that does nothing else.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "hidden/lines/visible_lines.h"
#include "programs/bench/growth.h"
#include "programs/bench/side_by_side.h"
#include "programs/bench/timing.h"
#include "tests/bench/command_line.h"
#include "tests/bench/device_scene.h"
#include "tests/bench/growth_options.h"
#include "tests/bench/result_table.h"

namespace displayfile::bench {
namespace {

struct Options : GrowthOptions {
  std::vector<std::string> scenes = {"terrain", "village", "soup"};
};

/// A scene with all its sides, each shared one once.
struct LinesOfScene {
  explicit LinesOfScene(DeviceScene scene_) : scene(std::move(scene_)) {
    std::ranges::fill(scene.visible, std::uint8_t{1});
    lines = drawn_lines(scene.items());
  }
  SeenLines find(HiddenMethod method, bool exact, int threads) const {
    LineOptions options;
    options.precision.exact = exact;
    options.threads = threads;
    return visible_lines(scene.items(), lines, method, options);
  }
  DeviceScene scene;
  std::vector<LineName> lines;
};

std::string text(const Spread& s) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", s.median, s.least, s.greatest);
}

/// Franklin's time is the unit, exact on that many threads.
std::vector<std::string> ratios_of(const LinesOfScene& of, const Options& options) {
  const auto franklin = [&](bool exact, int threads) {
    return [&of, exact, threads] { of.find(HiddenMethod::franklin, exact, threads); };
  };
  const auto ours = franklin(true, options.threads);
  const std::size_t pieces = of.find(HiddenMethod::franklin, true, 1).pieces.size();
  const Spread exact = times_faster(options.rounds, franklin(false, options.threads), ours);
  const Spread roberts =
      times_faster(1, ours, [&] { of.find(HiddenMethod::roberts, true, options.threads); });
  const Spread appel = times_faster(options.rounds, ours,
                                    [&] { of.find(HiddenMethod::appel, true, options.threads); });
  const Spread appel_exact = times_faster(
      options.rounds, [&] { of.find(HiddenMethod::appel, false, options.threads); },
      [&] { of.find(HiddenMethod::appel, true, options.threads); });
  const Spread one = times_faster(options.rounds, ours, franklin(true, 1));
  return {of.scene.name,
          std::to_string(of.scene.size()),
          std::to_string(of.lines.size()),
          std::to_string(pieces),
          text(exact),
          fmt::format("{:.2f}", roberts.median),
          fmt::format("{:.2f}", appel.median),
          fmt::format("{:.2f}", appel_exact.median),
          options.threads == 1 ? "" : text(one)};
}

double time_of(const LinesOfScene& of, HiddenMethod method, const Options& options) {
  return least_seconds_each(clock_of(options.threads), 3,
                            [&] { of.find(method, true, options.threads); });
}

std::vector<std::string> growth_of(const std::string& name, const Options& options) {
  std::vector<double> sizes, by_franklin, by_appel, overlaps;
  for (const std::size_t n : sizes_of_growth(options.low, options.high)) {
    const LinesOfScene of(generated(name, n));
    sizes.push_back(static_cast<double>(of.scene.size()));
    overlaps.push_back(overlaps_per_polygon(of.scene));
    by_franklin.push_back(time_of(of, HiddenMethod::franklin, options));
    by_appel.push_back(time_of(of, HiddenMethod::appel, options));
  }
  return {name, options.sizes(), fmt::format("{:.2f}", fitted_exponent(sizes, by_franklin)),
          fmt::format("{:.2f}", fitted_exponent(sizes, by_appel)),
          fmt::format("{:.1f} to {:.1f}", overlaps.front(), overlaps.back())};
}

void run(const Options& options) {
  fmt::print(
      "Hidden lines of all sides, {} thread(s). Times in one run: the median of {} rounds, least "
      "and greatest.\n\n",
      options.threads, options.rounds);
  std::vector<std::vector<std::string>> rows;
  for (const std::string& mesh : options.meshes) {
    rows.push_back(ratios_of(LinesOfScene(read_model(mesh).all), options));
  }
  for (const std::string& name : options.scenes) {
    rows.push_back(ratios_of(LinesOfScene(generated(name, 20'000)), options));
  }
  fmt::print("{}", text_table({"scene", "polygons", "lines", "pieces", "exact over roundoff",
                               "Roberts over Franklin", "Appel over Franklin",
                               "Appel, exact over roundoff", "one thread over these"},
                              rows));
  if (!options.want_growth()) return;
  rows.clear();
  for (const std::string& name : options.scenes) rows.push_back(growth_of(name, options));
  fmt::print("\nGrowth\n\n{}", text_table({"scene", "polygons", "Franklin's exponent", "Appel's",
                                           "extents overlapped by each"},
                                          rows));
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  displayfile::bench::Options options;
  CLI::App app("Hidden lines, compared", "hidden_lines_bench");
  add_options(app, options);
  app.add_option("--scenes", options.scenes, "generated scenes")->delimiter(',');
  return displayfile::bench::parsed_and_run(app, argc, argv,
                                            [&] { displayfile::bench::run(options); });
}
