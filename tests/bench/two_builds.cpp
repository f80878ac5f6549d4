// Every method by two builds of the command, on generated scenes, in turn: what drawing takes
// beyond starting and reading, by the second build in units of the first. A build before a change
// is held against the one after it. With --mesh: whole processes that draw mesh files to PNG.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "clip/error.h"
#include "programs/bench/process.h"
#include "programs/bench/side_by_side.h"
#include "programs/bench/temporary_folder.h"
#include "programs/scenes/generated_scenes.h"
#include "tests/bench/scene_program.h"

namespace displayfile::bench {
namespace {

struct Wanted {
  std::string before, after;
  std::vector<std::string> methods{"none",      "bsp",         "depth-sort", "z-buffer",
                                   "scan-line", "scan-line-z", "ray-cast",   "warnock"};
  std::vector<std::string> precisions{"exact", "roundoff"};
  std::vector<std::string> scenes;
  std::vector<std::size_t> polygons{2000};
  std::vector<int> sizes{384};
  std::vector<std::string> meshes;
  int threads = 1;     // of meshes
  std::string hidden;  // the method that draws them, if it is said
  std::uint64_t seed = 1;
  int rounds = 7;
};

/// Whole processes, the least of all rounds: what disturbs them only adds.
struct Least {
  double time = 1e300, memory = 1e300;
  void take(const Cost& cost) {
    time = std::min(time, cost.processor);
    memory = std::min(memory, cost.peak_memory);
  }
};

/// A drawing that takes as good as no time: the processes differ in their start and in reading.
Cost started(const std::string& command, const std::string& program,
             const TemporaryFolder& folder) {
  return cost_of({command, "draw", program, "-o", folder.file("start.ppm"), "--size", "1x1",
                  "--hidden", "none", "--threads", "1"});
}

struct Ratios {
  double time, memory;
};

class TwoBuilds {
 public:
  explicit TwoBuilds(const Wanted& wanted) : wanted_(wanted) {}

  void compare() {
    fmt::print("{:<28}{:<12}{:<10}{:>8}{:>8}\n", "scene", "method", "precision", "time", "memory");
    for (const GeneratedScene& scene : generated_scenes()) {
      const bool all = wanted_.scenes.empty();
      if (!all && std::ranges::find(wanted_.scenes, scene.name) == wanted_.scenes.end()) continue;
      for (const std::size_t n : wanted_.polygons) compare(scene, n);
    }
    fmt::print("largest: time {:.3f}, memory {:.3f}\n", largest_.time, largest_.memory);
  }

 private:
  void compare(const GeneratedScene& scene, std::size_t polygons) {
    const std::string program = folder_.file("scene.draw");
    write_program(scene.make(polygons, wanted_.seed), program);
    Least start[2];
    for (int round = 0; round < wanted_.rounds; ++round) {
      start[0].take(started(wanted_.before, program, folder_));
      start[1].take(started(wanted_.after, program, folder_));
    }
    for (const int size : wanted_.sizes) {
      for (const std::string& method : wanted_.methods) {
        for (const std::string& precision : wanted_.precisions) {
          fmt::print("{:<28}{:<12}{:<10}",
                     fmt::format("{} n={} {}x{}", scene.name, polygons, size, size), method,
                     precision);
          print(program, size, method, precision, start);
          std::fflush(stdout);
        }
      }
    }
  }

  /// A method that has a limit, as depth sort has, says so instead.
  void print(const std::string& program, int size, const std::string& method,
             const std::string& precision, const Least (&start)[2]) {
    try {
      const Ratios ratios = compare(program, size, method, precision, start);
      fmt::print("{:>8.3f}{:>8.3f}\n", ratios.time, ratios.memory);
      largest_.time = std::max(largest_.time, ratios.time);
      largest_.memory = std::max(largest_.memory, ratios.memory);
    } catch (const Error& error) {
      fmt::print("  {}\n", error.what());
    }
  }

  /// Memory includes what starting takes, since a build may start with less of it. Throws Error if
  /// a build does not draw the scene so, or draws it in less time than it takes to start.
  Ratios compare(const std::string& program, int size, const std::string& method,
                 const std::string& precision, const Least (&start)[2]) {
    Least drawn[2];
    const std::string* const commands[2]{&wanted_.before, &wanted_.after};
    for (int round = 0; round < wanted_.rounds; ++round) {
      for (const int k : {0, 1}) {
        drawn[k].take(cost_of({*commands[k], "draw", program, "-o", folder_.file("drawn.ppm"),
                               "--size", fmt::format("{}x{}", size, size), "--hidden", method,
                               "--precision", precision, "--threads", "1"}));
      }
    }
    const auto beyond = [&](int k) { return drawn[k].time - start[k].time; };
    for (const int k : {0, 1}) {
      if (beyond(k) < start[k].time) {
        throw Error("too short beside starting to be told: expected a larger scene or picture");
      }
    }
    return {beyond(1) / beyond(0), drawn[1].memory / drawn[0].memory};
  }

  Wanted wanted_;
  TemporaryFolder folder_;
  Ratios largest_{0.0, 0.0};
};

/// Mesh files to PNG, from the start of the process to its end, by the builds in turn: how many
/// times as much the first takes. The pictures must be the same.
class MeshesByTwoBuilds {
 public:
  explicit MeshesByTwoBuilds(const Wanted& wanted) : wanted_(wanted) {}

  void compare() {
    fmt::print("{:<40}{:>12}{:>8}{:>8}\n", "mesh to PNG, before / after", "processor", "wall",
               "memory");
    for (const std::string& mesh : wanted_.meshes) {
      for (const int size : wanted_.sizes) compare(mesh, size);
    }
  }

 private:
  void compare(const std::string& mesh, int size) {
    if (picture_of(wanted_.before, mesh, size) != picture_of(wanted_.after, mesh, size)) {
      throw Error(fmt::format("{}: the builds draw different pictures", mesh));
    }
    std::vector<double> processor, wall, memory;
    for (int round = 0; round < wanted_.rounds; ++round) {
      const Cost before = cost_of(drawing(wanted_.before, mesh, size, "drawn.png"));
      const Cost after = cost_of(drawing(wanted_.after, mesh, size, "drawn.png"));
      processor.push_back(before.processor / after.processor);
      wall.push_back(before.wall / after.wall);
      memory.push_back(before.peak_memory / after.peak_memory);
    }
    const std::string name = std::filesystem::path(mesh).filename().string();
    fmt::print("{:<40}{:>12.2f}{:>8.2f}{:>8.2f}\n", fmt::format("{} {}x{}", name, size, size),
               spread(processor).median, spread(wall).median, spread(memory).median);
    std::fflush(stdout);
  }

  std::vector<std::string> drawing(const std::string& command, const std::string& mesh, int size,
                                   const std::string& output) const {
    std::vector<std::string> line{command,
                                  "draw",
                                  mesh,
                                  "-o",
                                  folder_.file(output),
                                  "--size",
                                  fmt::format("{}x{}", size, size),
                                  "--threads",
                                  std::to_string(wanted_.threads)};
    if (!wanted_.hidden.empty()) line.insert(line.end(), {"--hidden", wanted_.hidden});
    return line;
  }
  /// The bytes of its pixels.
  std::string picture_of(const std::string& command, const std::string& mesh, int size) const {
    cost_of(drawing(command, mesh, size, "drawn.ppm"));
    std::ifstream file(folder_.file("drawn.ppm"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  Wanted wanted_;
  TemporaryFolder folder_;
};

int compare_builds(int argc, char** argv) {
  Wanted wanted;
  CLI::App app("Every method by two builds of the command: time beyond starting, and peak memory");
  app.add_option("BEFORE", wanted.before, "the command as one build made it")->required();
  app.add_option("AFTER", wanted.after, "and as another did")->required();
  app.add_option("--methods", wanted.methods, "only these")->delimiter(',');
  app.add_option("--precisions", wanted.precisions)->delimiter(',');
  app.add_option("--scenes", wanted.scenes, "only these")->delimiter(',');
  app.add_option("--polygons", wanted.polygons)->delimiter(',');
  app.add_option("--sizes", wanted.sizes, "pixels a side")->delimiter(',');
  app.add_option("--mesh", wanted.meshes, "draw these mesh files to PNG, whole processes, instead")
      ->delimiter(',')
      ->check(CLI::ExistingFile);
  app.add_option("--threads", wanted.threads, "of --mesh")->check(CLI::Range(1, 1024));
  app.add_option("--hidden", wanted.hidden, "the method that draws --mesh");
  app.add_option("--seed", wanted.seed);
  app.add_option("--rounds", wanted.rounds)->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  if (wanted.meshes.empty()) {
    TwoBuilds(wanted).compare();
  } else {
    MeshesByTwoBuilds(wanted).compare();
  }
  return 0;
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  try {
    return displayfile::bench::compare_builds(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "two_builds: {}\n", error.what());
    return 2;
  }
}
