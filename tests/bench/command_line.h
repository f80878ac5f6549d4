#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

namespace displayfile::bench {

/// What main returns: what the app says of its command line, or 0 when `run` has used it, or 1
/// after a line on standard error with the app's name if `run` throws.
template <class Run>
int parsed_and_run(CLI::App& app, int argc, char** argv, const Run& run) {
  CLI11_PARSE(app, argc, argv);
  try {
    run();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", app.get_name(), error.what());
    return 1;
  }
  return 0;
}

}  // namespace displayfile::bench
