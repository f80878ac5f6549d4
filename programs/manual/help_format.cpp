#include "programs/manual/help_format.h"

#include <algorithm>
#include <string_view>

#include "programs/manual/value_name.h"

namespace displayfile {

namespace {

constexpr std::size_t kTextColumn = 30;

/// A line with a name and, from kTextColumn on, a text in lines between words; below the name if
/// that is long.
std::string entry(const std::string& name, std::string_view text) {
  std::string all = "  " + name;
  std::size_t column = all.size();
  if (column + 2 > kTextColumn && !text.empty()) {
    all += '\n';
    column = 0;
  }
  bool is_first = true;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find(' '), text.size());
    if (!is_first && column + 1 + length > HelpFormat::kColumns) {
      all += '\n';
      column = 0;
      is_first = true;
    }
    const std::size_t blanks = is_first ? kTextColumn - column : 1;
    all.append(blanks, ' ').append(text.substr(0, length));
    column += blanks + length;
    is_first = false;
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return all + '\n';
}

}  // namespace

HelpFormat::HelpFormat() {
  label("Positionals", "Arguments");
  label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  std::string name = make_option_name(option, is_positional);
  if (option->get_items_expected_max() > 0) {
    const std::string value = value_name(*option).name;
    if (!value.empty() && value != name) name += " " + value;
  }
  const std::string text = option->get_description() + option_facts(*option);
  return entry(name, text.starts_with("; ") ? std::string_view(text).substr(2) : text);
}

std::string HelpFormat::make_subcommand(const CLI::App* command) const {
  return entry(command->get_display_name(true), command->get_description());
}

}  // namespace displayfile
