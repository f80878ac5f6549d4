#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "programs/options/import_words.h"

namespace displayfile {

/// `displayfile sheet`: four views of a part on a sheet of paper.
struct SheetCommand {
  std::vector<std::string> inputs;
  std::string output, paper = "a3", scale, projection = "third", unit, title, date, up;
  std::string font = "sans-serif";
  std::string lines = "outline,boundary,crease", hidden_lines, uncut;
  std::string centre_lines = "on";
  std::vector<std::string> sections, details;
  bool parts_list = false;
  double margin = 10.0;
  std::optional<double> hatch;
  int threads = 1;
  ImportWords import;

  CLI::App& add_to(CLI::App& app);
  int run();
};

}  // namespace displayfile
