#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "interp/draw/draw.h"

namespace displayfile {

/// The options --paper, --margin, --pens, --hatch, --order and --pen-layers, as words.
struct PaperWords {
  std::string paper, hatch;
  std::optional<double> margin;
  std::optional<std::string> order, layers;
  bool pens = false;

  void add_to(CLI::App& command);
  /// Sets the paper and the pens of the options. Throws Error for a word that is none, or for a
  /// length out of its range.
  void read(DrawOptions& options) const;
};

}  // namespace displayfile
