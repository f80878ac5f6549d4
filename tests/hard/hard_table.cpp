#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "clip/system/descriptors.h"
#include "displayfile/text/output_file.h"
#include "hard/document.h"
#include "hard/right_picture.h"
#include "hard/tally.h"
#include "hidden/exact/predicate_counts.h"
#include "mesa_leaks.h"
#include "programs/scenes/hard_cases.h"
#include "programs/scenes/mesh_scenes.h"
#include "programs/scenes/random_scenes.h"

// One table: family x method x precision, wrong pixels against the exact truth.

namespace displayfile {
namespace {

struct Options {
  int size = 32;
  int seeds = 3;
  int random = 200;
  std::vector<std::string> families, without, meshes;
  std::string severity = "table", csv;
  bool document = false, list = false, exact = false, touching_off = false;
};

const std::string kRandom = "random degenerate";

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

/// A method is left out by its name in the table, or by the first word of it.
std::vector<Method> chosen_methods(const Options& options) {
  std::vector<Method> chosen = methods();
  std::erase_if(chosen, [&](const Method& method) {
    return (options.exact && !method.exact) || contains(options.without, method.column) ||
           contains(options.without, method.column.substr(0, method.column.find(' ')));
  });
  return chosen;
}

bool is_of_what_touches(const HardCase& family) {
  return family.judged_from == JudgedFrom::entered;
}

std::vector<HardCase> chosen_families(const Options& options) {
  std::vector<HardCase> chosen;
  for (const std::string& name : options.families) chosen.push_back(hard_case(name));
  if (options.touching_off && !std::ranges::all_of(chosen, is_of_what_touches)) {
    throw Error("--touching-off is only for families that are judged from what was entered");
  }
  if (!chosen.empty()) return chosen;
  for (const HardCase& family : hard_cases()) {
    if (!options.touching_off || is_of_what_touches(family)) chosen.push_back(family);
  }
  return chosen;
}

/// On a terminal, the current measurement.
class Progress {
 public:
  void show(std::string_view name) const {
    if (on_) fmt::print(stderr, "\r{:<40}", name);
  }
  ~Progress() {
    if (on_) fmt::print(stderr, "\r{:<40}\r", "");
  }

 private:
  bool on_ = errors_are_on_terminal();
};

Tally judge_by_display_file(const Scene& scene, const Options& options,
                            const std::vector<Method>& methods) {
  return judge(scene, right_picture(scene, JudgedFrom::display_file, options.size), methods);
}

Tally judge_family(const HardCase& family, double severity, const Options& options,
                   const std::vector<Method>& methods) {
  Tally tally;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    Scene scene = family.make(family.size, severity, static_cast<std::uint64_t>(seed));
    const Picture right = right_picture(scene, family.judged_from, options.size);
    if (options.touching_off) scene.touching = {Touching::Kind::off};
    tally += judge(scene, right, methods);
  }
  return tally;
}

std::vector<TableRow> family_rows(const Options& options, const std::vector<Method>& methods) {
  const Progress progress;
  std::vector<TableRow> rows;
  for (const HardCase& family : chosen_families(options)) {
    if (options.seeds == 0) break;
    progress.show(family.name);
    TableRow row{std::string(family.name), {}};
    std::vector<double> severities = family.severities;
    if (options.severity != "table") severities = {std::stod(options.severity)};
    for (double severity : severities) {
      row.tally += judge_family(family, severity, options, methods);
    }
    rows.push_back(row);
  }
  if (options.random > 0 && options.families.empty() && !options.touching_off) {
    progress.show(kRandom);
    TableRow row{kRandom, {}};
    for (int seed = 0; seed < options.random; ++seed) {
      row.tally += judge_by_display_file(random_degenerate_scene(static_cast<std::uint64_t>(seed)),
                                         options, methods);
    }
    rows.push_back(row);
  }
  return rows;
}

/// One row a mesh, over all directions.
std::vector<TableRow> mesh_rows(const Options& options, const std::vector<Method>& methods) {
  const Progress progress;
  std::vector<TableRow> rows;
  for (const std::string& file : options.meshes) {
    const Mesh mesh = read_mesh(file);
    TableRow row{std::filesystem::path(file).stem().string(), {}};
    for (const MeshDirection& direction : mesh_directions()) {
      progress.show(row.name + ", " + std::string(direction.name));
      row.tally += judge_by_display_file(mesh_scene(mesh, direction), options, methods);
    }
    rows.push_back(row);
  }
  return rows;
}

/// One row a gap, from 1e-1 to 1e-17, summed over the families with gaps.
std::vector<TableRow> sweep_rows(const Options& options, const std::vector<Method>& methods) {
  const Progress progress;
  std::vector<TableRow> rows;
  for (int power = 1; power <= 17; ++power) {
    progress.show(fmt::format("gap 1e-{}", power));
    TableRow row{fmt::format("1e-{}", power), {}};
    for (const HardCase& family : chosen_families(options)) {
      if (family.has_gap()) row.tally += judge_family(family, power, options, methods);
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<TableRow> rows_of(const Options& options, const std::vector<Method>& methods) {
  if (!options.meshes.empty()) return mesh_rows(options, methods);
  return options.severity == "sweep" ? sweep_rows(options, methods) : family_rows(options, methods);
}

void print_list() {
  for (const HardCase& family : hard_cases()) {
    std::string severities;
    for (double severity : family.severities) severities += fmt::format(" {:g}", severity);
    fmt::print("{}: {}; size {}; severity ({}):{}\n", family.name, family.what, family.size,
               family.severity_means, severities);
  }
}

void write_file(const std::string& path, const std::string& text) {
  OutputFile out(path);
  out.stream() << text;
  out.commit();
}

/// False if a method that claims to be exact has a wrong pixel.
bool exact_methods_are_right(const std::vector<TableRow>& rows,
                             const std::vector<Method>& methods) {
  bool right = true;
  for (const TableRow& row : rows) {
    for (std::size_t i = 0; i < methods.size(); ++i) {
      if (!methods[i].exact || row.tally.wrong[i] == 0) continue;
      fmt::print(stderr, "{}: {} wrong pixels by {}\n", row.name, row.tally.wrong[i],
                 methods[i].name);
      right = false;
    }
  }
  return right;
}

/// Prints the counts of all methods and scenes together.
void print_exact_stage_counts() {
  fmt::print("The predicates' exact stage was asked:\n");
  const PredicateCounts counts = predicate_counts();
  for (std::size_t i = 0; i < kPredicates; ++i) {
    if (counts[i].exact + counts[i].by_definition == 0) continue;
    fmt::print("  {:<16} {:>9} times, and {} zero by definition\n",
               name_of(static_cast<Predicate>(i)), counts[i].exact, counts[i].by_definition);
  }
}

int run(const Options& options) {
  if (options.list) {
    print_list();
    return 0;
  }
  const std::vector<Method> methods = chosen_methods(options);
  if (options.document) {
    Options gaps = options;
    const auto rows = family_rows(options, methods);
    std::vector<Sweep> sweeps;
    for (const char* family : {"parallel_sheets", "cycle", "shallow_crossing"}) {
      gaps.families = {family};
      sweeps.push_back({family, sweep_rows(gaps, methods)});
    }
    gaps.families = {};
    sweeps.push_back({"all families with a gap", sweep_rows(gaps, methods)});
    Options off = options;
    off.touching_off = true;
    const auto off_rows = family_rows(off, methods);
    fmt::print("{}", document(rows, off_rows, sweeps, methods, options.size, options.seeds,
                              options.random));
    return exact_methods_are_right(rows, methods) ? 0 : 1;
  }
  const auto start = std::chrono::steady_clock::now();
  const bool sweep = options.severity == "sweep";
  const auto rows = rows_of(options, methods);
  const std::string first = !options.meshes.empty() ? "mesh" : sweep ? "gap" : "family";
  fmt::print("Wrong pixels against the exact truth, {0} x {0} pixels{1}\n\n{2}", options.size,
             options.touching_off ? ", drawn with set-touching off" : "",
             text_table(rows, methods, first));
  if (sweep) fmt::print("\n{}", where_each_breaks(rows, methods));
  fmt::print("\n{}", notes(methods));
  print_exact_stage_counts();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  fmt::print("{:.1f} s\n", seconds.count());
  if (!options.csv.empty()) write_file(options.csv, csv_table(rows, methods, first));
  if (options.touching_off) return 0;  // exact is then the result of rounding
  return exact_methods_are_right(rows, methods) ? 0 : 1;
}

}  // namespace
}  // namespace displayfile

int main(int argc, char** argv) {
  setenv("LP_NUM_THREADS", "0", 0);  // llvmpipe's threads cost more than such pictures do
  displayfile::Options options;
  CLI::App app("Hard cases: wrong pixels of each method against the exact truth");
  app.add_option("--size", options.size, "pixels a side")->check(CLI::Range(1, 4096));
  app.add_option("--seeds", options.seeds, "scenes a family and severity; 0: no families")
      ->check(CLI::Range(0, 1000000));
  app.add_option("--random", options.random, "random degenerate scenes")
      ->check(CLI::Range(0, 100000000));
  app.add_option("--families", options.families, "only these (see --list)")->delimiter(',');
  app.add_option("--without", options.without, "leave methods out: osmesa, ro, painter, ...")
      ->delimiter(',');
  app.add_flag("--exact", options.exact, "only methods that claim to have no wrong pixel");
  app.add_flag("--touching-off", options.touching_off,
               "only families that touch, drawn with set-touching off; the truth stays");
  app.add_option("--severity", options.severity,
                 "table: each family's own; sweep: gaps of 1e-1 to 1e-17; or a number")
      ->check(CLI::IsMember({"table", "sweep"}) | CLI::Number);
  app.add_option("--meshes", options.meshes,
                 "these meshes, each from six directions, in place of the families")
      ->delimiter(',')
      ->check(CLI::ExistingFile);
  app.add_option("--csv", options.csv, "write the table to this file too");
  app.add_flag("--document", options.document, "print tests/hard/README.md");
  app.add_flag("--list", options.list, "the families");
  CLI11_PARSE(app, argc, argv);
  try {
    return displayfile::run(options);
  } catch (const displayfile::Error& error) {
    fmt::print(stderr, "hard_table: {}\n", error.what());
    return 2;
  }
}
