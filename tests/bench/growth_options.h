#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace displayfile::bench {

/// What is asked of a bench that compares methods on meshes and tells how their times grow.
struct GrowthOptions {
  std::vector<std::string> meshes;
  int threads = 1;
  int rounds = 5;
  int low = 4, high = 6;  ///< of the sizes of growth, powers of ten

  bool want_growth() const { return high > low; }
  std::string sizes() const { return fmt::format("10^{} to 10^{}", low, high); }
};

inline void add_options(CLI::App& app, GrowthOptions& options) {
  app.add_option("meshes", options.meshes, "meshes")->check(CLI::ExistingFile);
  app.add_option("--threads", options.threads)->check(CLI::Range(1, 1024));
  app.add_option("--rounds", options.rounds)->check(CLI::Range(1, 1000));
  app.add_option("--low", options.low, "growth from 10^this")->check(CLI::Range(1, 7));
  app.add_option("--high", options.high, "growth to 10^this; no more than --low: none")
      ->check(CLI::Range(1, 7));
}

}  // namespace displayfile::bench
