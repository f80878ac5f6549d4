#pragma once

#include <CLI/App.hpp>
#include <string>

#include "displayfile/sorted_display_file.h"

namespace displayfile {

/// The options of commands that find hidden surfaces, as words.
struct HiddenSurfaceWords {
  std::string hidden, scope, precision, hidden_lines;

  void add_to(CLI::App& command);
  /// Throws Error for an unknown word.
  HiddenSurfaceOptions options(int threads) const;
};

}  // namespace displayfile
