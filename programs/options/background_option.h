#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "displayfile/looks/style.h"

namespace displayfile {

/// The option --background, as a word.
struct BackgroundWord {
  std::string word;
  bool may_be_none = true;

  void add_to(CLI::App& command);
  /// For pictures without alpha: a colour, not `none`.
  void add_colour_to(CLI::App& command);
  /// None if it was not given. Throws Error for a word that is no background.
  std::optional<Background> background() const;
};

}  // namespace displayfile
