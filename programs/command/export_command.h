#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "programs/options/import_words.h"

namespace displayfile {

/// `displayfile export`: a file of solids from drawing programs and meshes.
struct ExportCommand {
  std::vector<std::string> inputs;
  std::string output;
  ImportWords import;

  CLI::App& add_to(CLI::App& app);
  int run();
};

}  // namespace displayfile
