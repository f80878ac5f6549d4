#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "clip/surfaces.h"
#include "displayfile/segments/sorted_display_file.h"
#include "programs/options/line_words.h"

namespace displayfile {

/// The options of commands that find hidden surfaces, as words.
struct HiddenSurfaceWords {
  std::string hidden, scope, precision, hidden_lines;
  std::optional<std::string> lines, touching;

  void add_to(CLI::App& command);
  /// Throws Error for an unknown word.
  HiddenSurfaceOptions options(int threads) const;
  /// What --lines sets; nothing if the programs set it. Throws Error likewise.
  std::optional<LineWords> line_words() const;
  /// The same for commands that select lines but give kinds no styles of their own: throws Error
  /// for a style, too.
  std::optional<LineSelection> line_selection() const;
  /// Within which distance polygons touch; nothing if the programs say it. Throws Error likewise.
  std::optional<Touching> touching_in_force() const;
};

/// The method of --hidden of a command that takes those methods only. Throws Error for any other
/// word, listing those; `lack` says what other methods lack.
HiddenMethod method_among(const std::string& word, std::span<const HiddenMethod> taken,
                          std::string_view lack);

/// The option that touching_of_option reads.
void add_touching_option(CLI::App& command, std::optional<std::string>& touching);
/// Throws Error, naming the option, for an unknown word.
Touching touching_of_option(const std::string& word);
/// What --lines selects. Throws Error, naming the option, for an unknown word, or a style.
LineSelection line_selection_of_option(const std::string& words);

}  // namespace displayfile
