#include "tests/bench/benchmark.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>

#include "tests/bench/command/growth.h"

namespace displayfile::bench {

bool Options::has(const std::string& part) const {
  return parts.empty() || std::ranges::find(parts, part) != parts.end();
}

std::vector<std::string> Options::scenes_or(std::vector<std::string> usual) const {
  return scenes.empty() ? usual : scenes;
}

std::vector<std::size_t> Options::sizes() const {
  return high > low ? sizes_of_growth(low, high) : std::vector<std::size_t>();
}

void print_row(const Json& row) {
  fmt::print("{}\n", row.dump());
  std::fflush(stdout);
}

namespace {

int parsed_and_run(int argc, char** argv) {
  Options options;
  CLI::App app(kAbout);
  app.add_option("INPUT", options.inputs, "meshes")->check(CLI::ExistingFile);
  app.add_option("--scenes", options.scenes, "generated ones, by name")->delimiter(',');
  app.add_option("--parts", options.parts, "only these of what is measured")->delimiter(',');
  app.add_option("--polygons", options.polygons, "of generated scenes, about");
  app.add_option("--size", options.size, "pixels a side")->check(CLI::Range(1, 65536));
  app.add_option("--threads", options.threads)->check(CLI::Range(1, 1024));
  app.add_option("--rounds", options.rounds, "of each comparison")->check(CLI::Range(1, 10'000));
  app.add_option("--low", options.low, "growth from 10^this")->check(CLI::Range(1, 7));
  app.add_option("--high", options.high, "growth to 10^this")->check(CLI::Range(1, 7));
  CLI11_PARSE(app, argc, argv);
  run(options);
  return 0;
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  try {
    return displayfile::bench::parsed_and_run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 2;
  }
}
