#include "programs/manual/manual_page.h"

#include <fmt/format.h>

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "programs/manual/licence.h"
#include "programs/manual/value_name.h"

namespace displayfile {

namespace {

constexpr std::string_view kExitStatus =
    ".SH EXIT STATUS\n"
    ".TP\n.B 0\nDone.\n"
    ".TP\n.B 1\nA difference was found.\n"
    ".TP\n.B 2\n"
    "The input or the command line was wrong, or a limit was reached.\n"
    "A message on standard error says what and where, and nothing is written, except pictures of\n"
    "many inputs or views that are already complete.\n";

/// A word as it is printed: a hyphen is printed as the one that is typed.
std::string escaped(std::string_view word) {
  std::string text;
  for (const char c : word) {
    if (c == '-') {
      text += "\\-";
    } else if (c == '\\') {
      text += "\\e";
    } else {
      text += c;
    }
  }
  return text;
}

std::string bold(std::string_view word) { return fmt::format("\\fB{}\\fR", escaped(word)); }

bool is_name_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Words to be typed literally in bold, placeholders in italics.
std::string value_text(std::string_view name) {
  std::string text;
  for (std::size_t at = 0; at < name.size();) {
    std::size_t end = at;
    while (end < name.size() && (is_name_character(name[end]) || name[end] == '-')) ++end;
    const std::string_view word = name.substr(at, end - at);
    const bool is_extension = at > 0 && (name[at - 1] == '.' || name[at - 1] == '{');
    if (word.empty()) {
      text += name[end++];
    } else if (!is_extension && std::isupper(static_cast<unsigned char>(word.front())) != 0) {
      text += fmt::format("\\fI{}\\fR", escaped(word));
    } else {
      text += bold(word);
    }
    at = end;
  }
  return text;
}

/// Names of options are bold in descriptions too.
std::string word_of_text(std::string_view word) {
  const std::size_t begin = word.find("--");
  if (begin == word.npos || begin + 2 >= word.size()) return escaped(word);
  std::size_t end = begin + 2;
  while (end < word.size() && (is_name_character(word[end]) || word[end] == '-')) ++end;
  if (end == begin + 2) return escaped(word);
  return escaped(word.substr(0, begin)) + bold(word.substr(begin, end - begin)) +
         escaped(word.substr(end));
}

/// A paragraph in lines of some length, none of which looks like a request; `line` is the beginning
/// of the first.
void print_text(std::string_view text, std::ostream& out, std::string line = "") {
  constexpr std::size_t kLength = 78;
  const auto end_line = [&] {
    if (line.starts_with('.') || line.starts_with('\'')) out << "\\&";
    if (!line.empty()) out << line << '\n';
    line.clear();
  };
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string word = word_of_text(text.substr(0, blank));
    text.remove_prefix(std::min(blank + 1, text.size()));
    if (word.empty()) continue;
    if (line.size() + 1 + word.size() > kLength) end_line();
    line += (line.empty() ? "" : " ") + word;
  }
  end_line();
}

bool takes_many(const CLI::Option& option) {
  return option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

/// "-o, --output OUT"
std::string option_text(const CLI::Option& option) {
  std::string text;
  const auto append = [&](const std::string& name) {
    text += (text.empty() ? "" : ", ") + bold(name);
  };
  for (const std::string& name : option.get_snames()) append("-" + name);
  for (const std::string& name : option.get_lnames()) append("--" + name);
  if (option.get_items_expected_max() > 0) text += " " + value_text(value_name(option).name);
  return text;
}

std::string positional_text(const CLI::Option& option) {
  return fmt::format("\\fI{}\\fR{}", escaped(option.get_name(true, false)),
                     takes_many(option) ? "..." : "");
}

void print_option(const CLI::Option& option, const std::string& head, std::ostream& out) {
  out << ".TP\n" << head << '\n';
  const std::string text = option.get_description() + option_facts(option);
  print_text(text.starts_with("; ") ? std::string_view(text).substr(2) : text, out);
}

void print_options(const CLI::App& command, std::ostream& out) {
  const std::vector<std::string> groups = command.get_groups();
  for (const std::string& group : groups) {
    if (group.empty()) continue;
    bool is_first = true;
    for (const CLI::Option* option : command.get_options()) {
      if (!option->nonpositional() || option->get_group() != group) continue;
      if (is_first && group != "Options") out << ".SS " << group << '\n';
      is_first = false;
      print_option(*option, option_text(*option), out);
    }
  }
}

/// The description as it stands after the name: it begins in lower case, and ends with its
/// sentence.
std::string name_text(const CLI::App& command) {
  std::string text = command.get_description();
  text = text.substr(0, text.find(';'));
  if (text.ends_with('.')) text.pop_back();
  if (text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1])) == 0) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

void print_synopsis(const CLI::App& app, const CLI::App& command, std::ostream& out) {
  if (&app == &command) {
    out << fmt::format("{} \\fICOMMAND\\fR [\\fIARGUMENT\\fR]...\n", bold(app.get_name()));
    return;
  }
  std::string line = bold(app.get_name() + " " + command.get_name());
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    const std::string text = positional_text(*option);
    line += option->get_required() ? " " + text : fmt::format(" [{}]", text);
  }
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || !option->get_required()) continue;
    const bool is_short = !option->get_snames().empty();
    line += " " + bold(is_short ? "-" + option->get_snames().front()
                                : "--" + option->get_lnames().front());
    line += " " + value_text(value_name(*option).name);
  }
  out << line << " [\\fIOPTION\\fR]...\n";
}

}  // namespace

void print_manual_page(const CLI::App& app, const CLI::App& command, std::ostream& out) {
  const bool is_whole = &app == &command;
  const std::string name = is_whole ? app.get_name() : app.get_name() + "-" + command.get_name();
  out << ".SH NAME\n";
  print_text(name_text(command), out, escaped(name) + " \\-");
  out << ".SH SYNOPSIS\n";
  print_synopsis(app, command, out);
  out << ".SH DESCRIPTION\n";
  print_text(command.get_description() + (command.get_description().ends_with('.') ? "" : "."),
             out);
  if (is_whole) {
    out << ".SH COMMANDS\n";
    for (const CLI::App* each : app.get_subcommands({})) {
      out << ".TP\n" << fmt::format("{}(1)\n", bold(app.get_name() + "-" + each->get_name()));
      print_text(each->get_description() + ".", out);
    }
  }
  out << ".SH OPTIONS\n";
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) print_option(*option, positional_text(*option), out);
  }
  print_options(command, out);
  out << kExitStatus << ".SH LICENCE\n";
  print_text(licence_text() + '.', out);
}

}  // namespace displayfile
