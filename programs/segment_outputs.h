#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "displayfile/sorted_display_file.h"

namespace displayfile {

// The subcommands of `displayfile` that write or compare what segments hold, in the order that is
// drawn. They draw nothing.

/// The options of commands that sort hidden surfaces, as words.
struct HiddenSurfaceWords {
  std::string hidden, scope, precision;

  void add_to(CLI::App& command);
  /// Throws Error for an unknown word.
  HiddenSurfaceOptions options(int threads) const;
};

struct DumpCommand {
  std::vector<std::string> inputs;
  HiddenSurfaceWords hidden_surfaces;
  int threads = 1;
  std::string output;  ///< standard output if empty

  CLI::App& add_to(CLI::App& app);
  int run() const;  ///< 0; throws Error with nothing written
};

/// Against golden files.
struct CheckCommand {
  std::vector<std::string> inputs;
  HiddenSurfaceWords hidden_surfaces;
  int threads = 1;
  std::string golden_folder;
  bool update = false;

  CLI::App& add_to(CLI::App& app);
  int run() const;  ///< 1 if a difference was found, otherwise 0; throws Error
};

}  // namespace displayfile
