// What it costs that polygons share planes as entered (hidden/touching_planes.md), by two builds of
// the command, before it did so and after: instructions of drawings, counted by callgrind
// (tests/bench/README.md, touching_cost).

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/error.h"
#include "programs/bench/callgrind.h"
#include "programs/bench/process.h"
#include "programs/bench/temporary_folder.h"
#include "programs/exit_status.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/bench/result_table.h"
#include "tests/bench/scene_program.h"
#include "tests/bench/touching_scenes.h"

namespace displayfile::bench {
namespace {

struct Wanted {
  std::string before, after;
  std::vector<std::string> entered_bytes;  // of both builds, or none
  std::vector<std::string> meshes, scenes;
  std::string keep;  // a folder
  std::size_t polygons = 1000;
  int size = 512;
  double limit = 120.0;  // seconds of a sort under callgrind
  std::uint64_t seed = 1;
};

/// Where these are in a function's name, or in its library's, it computes with exact numbers.
constexpr std::array<std::string_view, 9> kExact{
    "ExactNumber", "ExactVector",           "ExactPoint",         "ExactPlane",
    "exact_",      "displayfile::digits::", "displayfile::cross", "displayfile::operator*",
    "libgmp"};

/// A row of the results.
enum class Row : std::uint8_t {
  picture,
  moving,
  first,
  sort,
  touching_picture,
  touching_moving,
  touching_first,
  touching_bsp,
  touching_depth_sort,
  exact_stages,
  exact_sorts,
  lines,
  map,
  touching_lines,
  touching_map,
  against_off,
  own_points,
  shared_points,
  retained
};
struct Asked {
  Row row;
  std::string_view work;
  double most;  ///< 0: nothing is asked
};
constexpr Asked kAsked[] = {
    {Row::picture, "nothing touches: z-buffer, a picture", 1.08},
    {Row::moving, "nothing touches: z-buffer, a view of a moving camera", 1.08},
    {Row::first, "nothing touches: z-buffer, from the file to the first picture", 1.08},
    {Row::sort, "nothing touches: bsp, depth-sort", 1.15},
    {Row::touching_picture, "all touches: z-buffer, a picture, over roundoff before", 1.5},
    {Row::touching_moving, "all touches: z-buffer, a view of a moving camera, the same", 1.5},
    {Row::touching_first, "all touches: z-buffer, from the file to the first picture, the same",
     1.5},
    {Row::touching_bsp, "all touches: bsp, the same", 1.5},
    {Row::touching_depth_sort, "all touches: depth-sort, the same", 1.5},
    {Row::exact_stages, "all touches: exact numbers, of all instructions, z-buffer", 0.05},
    {Row::exact_sorts, "all touches: exact numbers, of all instructions, bsp, depth-sort", 0.05},
    {Row::lines, "nothing touches: franklin, appel, few lines and all", 1.2},
    {Row::map, "nothing touches: map", 1.2},
    {Row::touching_lines, "all touches: franklin, appel, over roundoff before", 1.5},
    {Row::touching_map, "all touches: map, auto over off", 1.5},
    {Row::against_off, "all scenes: auto over off, a picture by any of these", 0.0},
    {Row::own_points, "bytes a polygon: points of their own", 1.9},
    {Row::shared_points, "bytes a polygon: shared points", 1.3},
    {Row::retained, "bytes a polygon: retained", 1.0},
};

struct Figure {
  double value;
  std::string of;
};

/// A file that is drawn.
struct Drawn {
  std::string name, file;
  std::string lined;  ///< the same with its sides as lines
  bool touches;
};

/// The program with a line style, whatever it sets.
void write_lined(const std::string& program, const std::string& path) {
  std::ifstream in(program);
  std::ofstream out(path);
  for (std::string line; std::getline(in, line);) {
    out << (line.starts_with("set-line-style") ? "set-line-style solid 0 0 0 1" : line) << '\n';
  }
  if (!out.flush()) throw Error(path + ": not all could be written");
}

/// How it is drawn.
struct Way {
  std::string hidden = "none", precision = "exact";
  int size = 1;
  bool touching_off = false;
  int views = 0;           ///< of a moving camera; 0: a picture
  std::string lines = {};  ///< which kinds; empty: all
  bool is_vector = false;
};

/// What is drawn as vectors.
struct VectorWay {
  std::string_view hidden, lines;
};
constexpr std::array<VectorWay, 5> kVectorWays{{{"franklin", ""},
                                                {"franklin", "outline,crease"},
                                                {"appel", ""},
                                                {"appel", "outline,crease"},
                                                {"map", ""}}};

class TouchingCost {
 public:
  explicit TouchingCost(const Wanted& wanted) : wanted_(wanted) {}

  void compare() {
    const std::string nothing = folder_.file("nothing.draw");
    std::ofstream(nothing) << "open-segment 1\nclose-segment\n";
    for (const std::string* command : {&wanted_.before, &wanted_.after}) {
      start_[command] = counted(*command, nothing, {}).instructions();
    }
    for (const Drawn& drawn : files()) compare(drawn);
    if (!wanted_.entered_bytes.empty()) compare_bytes();
    print_results();
  }

 private:
  bool is_wanted(std::string_view name) const {
    return wanted_.scenes.empty() ||
           std::ranges::find(wanted_.scenes, name) != wanted_.scenes.end();
  }

  std::vector<Drawn> files() const {
    std::vector<Drawn> all;
    const auto add = [&](std::string_view name, const auto& make, bool touches) {
      if (!is_wanted(name)) return;
      const std::filesystem::path folder =
          wanted_.keep.empty() ? folder_.path() : std::filesystem::path(wanted_.keep);
      const std::string lined = folder_.file(fmt::format("{}-lined.draw", name));
      all.push_back(
          {std::string(name), (folder / fmt::format("{}.draw", name)).string(), lined, touches});
      // Each of them is cut by all others.
      const std::size_t fewer = name == "planes" ? 50 : 1;
      write_program(make(wanted_.polygons / fewer, wanted_.seed), all.back().file);
      write_lined(all.back().file, lined);
    };
    for (const GeneratedScene& scene : generated_scenes()) {
      // The floors of the buildings lie in one plane.
      if (scene.name != "city" && scene.name != "village") add(scene.name, scene.make, false);
    }
    for (const std::string& mesh : wanted_.meshes) {
      all.push_back({std::filesystem::path(mesh).filename().string(), mesh, mesh, false});
    }
    for (const TouchingScene& scene : touching_scenes()) add(scene.name, scene.make, true);
    return all;
  }

  WorkCount counted(const std::string& command, const std::string& file, const Way& way) const {
    return counted_run(line_of(command, file, way));
  }
  std::vector<std::string> line_of(const std::string& command, const std::string& file,
                                   const Way& way) const {
    std::vector<std::string> line{command,
                                  "draw",
                                  file,
                                  "-o",
                                  folder_.file(way.is_vector ? "drawn.svg" : "drawn.ppm"),
                                  "--size",
                                  fmt::format("{0}x{0}", way.size),
                                  "--hidden",
                                  way.hidden,
                                  "--precision",
                                  way.precision,
                                  "--threads",
                                  "1",
                                  "--quiet"};
    if (!way.lines.empty()) line.insert(line.end(), {"--lines", way.lines});
    if (way.touching_off) line.insert(line.end(), {"--touching", "off"});
    if (way.views > 0) {
      line.insert(line.end(), {"--turntable", "36", "--views", fmt::format("0:{}", way.views)});
    }
    return line;
  }
  double instructions(const std::string& command, const Drawn& drawn, const Way& way) const {
    return static_cast<double>(counted(command, drawn.file, way).instructions());
  }

  /// What one build takes for a file, in instructions.
  struct Work {
    double reading;               ///< and entering
    double picture, first, view;  ///< by the z-buffer; a view of a moving camera
    std::array<double, 2> sorts;  ///< 0: not counted
    double exact_of_picture;      ///< the part that computes with exact numbers
    std::array<double, 2> exact_of_sorts;
    std::array<double, kVectorWays.size()> vectors;  ///< 0: not counted
  };

  static constexpr std::array kSorts{"bsp", "depth-sort"};
  static constexpr std::array kRowsOfSorts{Row::touching_bsp, Row::touching_depth_sort};

  /// What touches is not sorted with touching off: what differs then is what is drawn.
  Work work(const std::string& command, const Drawn& drawn, const std::string& precision,
            bool touching_off) {
    Way way{.precision = precision, .touching_off = touching_off};
    Work work{};
    const double read = instructions(command, drawn, way);
    const auto start = static_cast<double>(start_.at(&command));
    work.reading = read - start;
    way.size = wanted_.size;
    for (std::size_t k = 0; k < kSorts.size() && !(touching_off && drawn.touches); ++k) {
      way.hidden = kSorts[k];
      std::tie(work.sorts[k], work.exact_of_sorts[k]) = sorted(command, drawn, way);
      work.sorts[k] -= read;
    }
    for (std::size_t k = 0; k < kVectorWays.size(); ++k) {
      const bool is_map = kVectorWays[k].hidden == "map";
      const bool is_compared = is_map ? precision == "exact" : !(touching_off && drawn.touches);
      if (is_compared) work.vectors[k] = vectors(command, drawn, way, kVectorWays[k]) - read;
    }
    way.hidden = "z-buffer";
    const WorkCount picture = counted(command, drawn.file, way);
    work.first = static_cast<double>(picture.instructions()) - start;
    work.picture = work.first - work.reading;
    work.exact_of_picture = static_cast<double>(picture.instructions_of(kExact));
    constexpr int kFew = 1, kMany = 13;  // what is made once for all views is made by then
    way.views = kFew;
    const double few = instructions(command, drawn, way);
    way.views = kMany;
    work.view = (instructions(command, drawn, way) - few) / (kMany - kFew);
    return work;
  }

  /// All instructions of a sort, and those that compute with exact numbers; infinite if it takes
  /// longer than the limit.
  std::pair<double, double> sorted(const std::string& command, const Drawn& drawn,
                                   const Way& way) const {
    std::vector<std::string> line = line_of(command, drawn.file, way);
    line.insert(line.end(), {"--limit-seconds", fmt::format("{}", wanted_.limit)});
    try {
      const WorkCount count = counted_run(line);
      return {static_cast<double>(count.instructions()),
              static_cast<double>(count.instructions_of(kExact))};
    } catch (const Error& error) {
      if (std::string_view(error.what()).find("limit") == std::string_view::npos) throw;
      return {std::numeric_limits<double>::infinity(), 0.0};
    }
  }

  double vectors(const std::string& command, const Drawn& drawn, Way way,
                 const VectorWay& as) const {
    way.hidden = as.hidden;
    way.lines = as.lines;
    way.is_vector = true;
    const std::string& file = as.hidden == "map" ? drawn.file : drawn.lined;
    return static_cast<double>(counted(command, file, way).instructions());
  }

  void compare_vectors(const Drawn& drawn, const Work& before, const Work& after, const Work& off) {
    for (std::size_t k = 0; k < kVectorWays.size(); ++k) {
      const auto& [hidden, lines] = kVectorWays[k];
      const bool is_map = hidden == "map";
      const double under = is_map && drawn.touches ? off.vectors[k] : before.vectors[k];
      if (!(under > 0.0)) continue;
      const Row row = drawn.touches ? (is_map ? Row::touching_map : Row::touching_lines)
                                    : (is_map ? Row::map : Row::lines);
      const std::string of =
          fmt::format("{}, {}{}", drawn.name, hidden, lines.empty() ? "" : ", few lines");
      take(row, after.vectors[k] / under, of);
      fmt::print("{}: {:.3f}\n", of, after.vectors[k] / under);
    }
  }

  void compare(const Drawn& drawn) {
    const Work before = work(wanted_.before, drawn, drawn.touches ? "roundoff" : "exact", false);
    const Work after = work(wanted_.after, drawn, "exact", false);
    const Work off = work(wanted_.after, drawn, "exact", true);
    take(drawn.touches ? Row::touching_picture : Row::picture, after.picture / before.picture,
         drawn.name);
    take(drawn.touches ? Row::touching_moving : Row::moving, after.view / before.view, drawn.name);
    take(drawn.touches ? Row::touching_first : Row::first, after.first / before.first, drawn.name);
    for (std::size_t k = 0; k < kSorts.size(); ++k) {
      take(drawn.touches ? kRowsOfSorts[k] : Row::sort, after.sorts[k] / before.sorts[k],
           fmt::format("{}, {}", drawn.name, kSorts[k]));
      if (drawn.touches && std::isfinite(after.sorts[k])) {
        take(Row::exact_sorts, after.exact_of_sorts[k] / after.sorts[k],
             fmt::format("{}, {}", drawn.name, kSorts[k]));
      }
      if (off.sorts[k] > 0.0) {
        take(Row::against_off, after.sorts[k] / off.sorts[k],
             fmt::format("{}, {}", drawn.name, kSorts[k]));
      }
    }
    take(Row::against_off, after.picture / off.picture, drawn.name);
    compare_vectors(drawn, before, after, off);
    if (drawn.touches) take(Row::exact_stages, after.exact_of_picture / after.picture, drawn.name);
    print(drawn, before, after, off);
  }

  /// What entered_bytes prints, by name.
  static std::map<std::string, double> bytes_by(const std::string& program) {
    const Finished finished = run({program});
    if (!finished.succeeded) throw Error(program + " failed");
    std::map<std::string, double> bytes;
    std::istringstream lines(finished.output);
    double value = 0.0;
    for (std::string name; lines >> value && std::getline(lines >> std::ws, name);) {
      bytes[name] = value;
    }
    return bytes;
  }

  void compare_bytes() {
    const auto before = bytes_by(wanted_.entered_bytes[0]);
    fmt::print("\n| bytes a polygon | before | after | ratio |\n| --- | ---: | ---: | ---: |\n");
    for (const auto& [name, bytes] : bytes_by(wanted_.entered_bytes[1])) {
      fmt::print("| {} | {:.1f} | {:.1f} | {:.3f} |\n", name, before.at(name), bytes,
                 bytes / before.at(name));
      const Row row = name.starts_with("retained") ? Row::retained
                      : name.starts_with("shared") ? Row::shared_points
                                                   : Row::own_points;
      take(row, bytes / before.at(name), name);
    }
  }

  /// No figure where nothing is left of what was counted, less the work that is not asked for.
  void take(Row row, double value, const std::string& of) {
    if (value > 0.0) figures_[row].push_back({value, of});
  }

  void print(const Drawn& drawn, const Work& before, const Work& after, const Work& off) {
    if (!heads_printed_) {
      fmt::print(
          "| {:<18} | {:<17} | reading | picture |  view   |  first  |   bsp   | depth-sort |\n",
          "scene", "ratio");
      fmt::print("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
      heads_printed_ = true;
    }
    const auto line = [&](std::string_view what, const Work& a, const Work& b) {
      fmt::print("| {:<18} | {:<17} |", drawn.name, what);
      for (const auto& [over, under] : {std::pair(a.reading, b.reading),
                                        {a.picture, b.picture},
                                        {a.view, b.view},
                                        {a.first, b.first},
                                        {a.sorts[0], b.sorts[0]},
                                        {a.sorts[1], b.sorts[1]}}) {
        const bool is_known = over > 0.0 && under > 0.0;
        fmt::print(" {:>7} |", is_known ? fmt::format("{:.3f}", over / under) : "");
      }
      fmt::print("\n");
    };
    line(drawn.touches ? "after / roundoff" : "after / before", after, before);
    line("auto / off", after, off);
    std::fflush(stdout);
  }

  void print_results() const {
    std::vector<Result> results;
    for (const Asked& asked : kAsked) {
      const auto found = figures_.find(asked.row);
      if (found == figures_.end()) continue;
      std::vector<Figure> figures = found->second;
      std::ranges::sort(figures, {}, &Figure::value);
      const Figure& worst = figures.back();
      results.push_back({std::string(asked.work),
                         asked.most > 0.0 ? fmt::format("at most {}", asked.most) : "",
                         fmt::format("{:.3f}", figures[figures.size() / 2].value),
                         fmt::format("{:.3f} to {:.3f}", figures.front().value, worst.value),
                         worst.of, asked.most > 0.0 ? holds_if(worst.value <= asked.most) : ""});
    }
    fmt::print("\nMedians of the scenes; beside each the scene of the greatest.\n\n{}",
               text_table(results));
  }

  Wanted wanted_;
  TemporaryFolder folder_;
  std::map<const std::string*, std::uint64_t> start_;
  std::map<Row, std::vector<Figure>> figures_;
  bool heads_printed_ = false;
};

int compare_builds(int argc, char** argv) {
  Wanted wanted;
  CLI::App app("What polygons that touch cost, by two builds of the command, in instructions");
  app.add_option("BEFORE", wanted.before, "the command of a build that knows nothing of it")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("AFTER", wanted.after, "and of one that does")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("MESH", wanted.meshes, "in which nothing touches")->check(CLI::ExistingFile);
  app.add_option("--entered-bytes", wanted.entered_bytes,
                 "the programs of that name of both builds, with a comma between")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::ExistingFile);
  app.add_option("--scenes", wanted.scenes, "only these")->delimiter(',');
  app.add_option("--keep", wanted.keep, "a folder in which the scenes stay as drawing programs")
      ->check(CLI::ExistingDirectory);
  app.add_option("--polygons", wanted.polygons, "of each scene, about");
  app.add_option("--size", wanted.size, "pixels a side")->check(CLI::Range(2, 16384));
  app.add_option("--limit", wanted.limit,
                 "seconds that a sort may take under callgrind; what takes longer counts as "
                 "infinite")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", wanted.seed);
  CLI11_PARSE(app, argc, argv);
  TouchingCost(wanted).compare();
  return 0;
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  return displayfile::exit_status(displayfile::bench::compare_builds, argc, argv);
}
