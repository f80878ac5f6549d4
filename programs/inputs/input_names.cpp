#include "programs/inputs/input_names.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

bool is_list(const std::string& word) { return word.size() > 1 && word[0] == '@'; }

bool is_there(const std::string& name) {
  std::error_code error;
  return name == "-" || std::filesystem::exists(name, error);
}

/// The words of a line between blanks, or between quotation marks.
Figure words_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t";
  Figure words;
  for (;;) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    if (line.empty()) return words;
    const bool is_quoted = line[0] == '"';
    if (is_quoted) line.remove_prefix(1);
    const std::size_t length = is_quoted ? line.find('"') : line.find_first_of(kBlanks);
    words.emplace_back(line.substr(0, length));
    line.remove_prefix(std::min(words.back().size() + 1, line.size()));
  }
}

Figure figure_of(std::string_view line) {
  const std::string whole(line);
  if (is_there(whole)) return {whole};
  const Figure words = words_of(line);
  return std::ranges::any_of(words, is_there) ? words : Figure{whole};
}

/// Line ends may be those of Windows; empty lines are ignored.
void append_figures_in(const std::string& list, std::vector<Figure>& figures) {
  const std::string text = read_text_file(list);
  if (text.find('\0') != std::string::npos) {
    throw Error(fmt::format("{}: holds a zero byte: expected names of inputs, one per line",
                            input_name(list)));
  }
  const std::size_t before = figures.size();
  for (std::string_view rest = without_byte_order_mark(text); !rest.empty();) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!line.empty()) figures.push_back(figure_of(line));
  }
  if (figures.size() == before) {
    throw Error(
        fmt::format("{}: is empty: expected names of inputs, one per line", input_name(list)));
  }
}

}  // namespace

std::vector<std::string> input_lists(const std::vector<std::string>& words) {
  std::vector<std::string> files;
  for (const std::string& word : words) {
    if (is_list(word)) files.push_back(word.substr(1));
  }
  return files;
}

std::vector<Figure> input_figures(const std::vector<std::string>& words) {
  std::vector<Figure> figures;
  bool list_is_standard_input = false;
  for (const std::string& word : words) {
    if (!is_list(word)) {
      figures.push_back({word});
      continue;
    }
    if (word == "@-" && list_is_standard_input) {
      throw Error("@-: standard input is read twice: expected it once");
    }
    list_is_standard_input = list_is_standard_input || word == "@-";
    append_figures_in(word.substr(1), figures);
  }
  const auto reads = std::ranges::count(inputs_of(figures), "-");
  if (list_is_standard_input && reads > 0) {
    throw Error("@- and -: standard input is read twice: expected it once");
  }
  if (reads > 1) throw Error("-: standard input is read twice: expected it once");
  return figures;
}

std::vector<Figure> with_common(const std::string& with, std::vector<Figure> figures) {
  if (with.empty()) return figures;
  if (with == "-") throw Error("--with -: is read for each input: expected a file");
  for (Figure& figure : figures) figure.insert(figure.begin(), with);
  return figures;
}

std::vector<std::string> figure_names(const std::vector<Figure>& figures) {
  std::vector<std::string> names;
  names.reserve(figures.size());
  for (const Figure& figure : figures) names.push_back(figure.back());
  return names;
}

std::vector<std::string> inputs_of(const std::vector<Figure>& figures) {
  std::vector<std::string> names;
  for (const Figure& figure : figures) names.insert(names.end(), figure.begin(), figure.end());
  return names;
}

std::vector<std::string> input_names(const std::vector<std::string>& words) {
  return inputs_of(input_figures(words));
}

void add_with(CLI::App& command, std::string& with) {
  command
      .add_option("--with", with,
                  "drawing program entered before each input, such as a view and styles that all "
                  "share")
      ->type_name("FILE.draw");
}

CLI::Option& add_inputs(CLI::App& command, const char* name, std::vector<std::string>& inputs,
                        const std::string& what) {
  CLI::Option& option = *command.add_option(name, inputs,
                                            what +
                                                "; @FILE reads names from a file, one per line or "
                                                "those of one picture, and @- from standard input");
  option.type_name("FILE.draw|MESH");
  return *option.required();
}

}  // namespace displayfile
