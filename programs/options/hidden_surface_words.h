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

/// The options of commands that find hidden surfaces, as the command line sets them. Reading it
/// throws Error for an unknown word.
struct HiddenSurfaceWords {
  HiddenSurfaceOptions surfaces;     ///< without the settings of --lines
  std::optional<LineWords> lines;    ///< none: programs select lines
  std::optional<Touching> touching;  ///< none: programs set it

  /// `lines_taken`: by --lines.
  void add_to(CLI::App& command, LineWords::Takes lines_taken = LineWords::Takes::kinds);
  /// Throws Error if --lines and --hidden-lines contradict each other.
  HiddenSurfaceOptions options() const;
  /// The selection of --lines, for commands that give kinds no styles of their own: throws Error
  /// for a style.
  std::optional<LineSelection> line_selection() const;
};

/// Adds an option whose value is read by `read`, which throws Error for an unknown word.
template <class Value, class Read>
CLI::Option* add_word_option(CLI::App& command, const std::string& name, Value& value, Read read,
                             const std::string& description) {
  const auto take = [&value, read](const std::string& word) { value = read(word); };
  return command.add_option_function<std::string>(name, take, description);
}

/// The method of --hidden for a command that supports only the methods `taken`. Throws Error for
/// any other word, listing them; `lack` describes what other methods lack.
HiddenMethod method_among(const std::string& word, std::span<const HiddenMethod> taken,
                          std::string_view lack);

void add_touching_option(CLI::App& command, std::optional<Touching>& touching);
/// The selection of --lines. Throws Error, naming the option, for a style.
LineSelection selection_of(const LineWords& lines);

}  // namespace displayfile
