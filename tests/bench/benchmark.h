#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/bench/command/report.h"

namespace displayfile::bench {

/// The options of a benchmark's command line; each uses some.
struct Options {
  std::vector<std::string> inputs;  ///< meshes, drawing programs
  std::vector<std::string> scenes;  ///< generated ones; none: the benchmark's own
  std::vector<std::string> parts;   ///< of the benchmark; none: all
  std::size_t polygons = 20'000;    ///< of generated scenes
  int size = 1024;                  ///< pixels a side
  int threads = 1, rounds = 5;
  int low = 0, high = 0;  ///< growth from 10^low to 10^high; no more than low: none

  bool has(const std::string& part) const;
  /// The scenes named, otherwise the usual ones.
  std::vector<std::string> scenes_or(std::vector<std::string> usual) const;
  /// Two a decade.
  std::vector<std::size_t> sizes() const;
};

/// Prints figures as a line of JSON. Those of a table have its name under "table";
/// tests/bench/table prints them as tables, and of rows with "n" and "seconds" the exponent of
/// growth.
void print_row(const Json& row);

/// Each benchmark defines these: a description, and the measurement. `main` (benchmark.cpp) reads
/// the command line, runs it, and ends with 2 after a line on standard error if it throws.
extern const char* const kAbout;
void run(const Options& options);

}  // namespace displayfile::bench
