#include "programs/inputs/input_names.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/input_file.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

bool is_list(const std::string& word) { return word.size() > 1 && word[0] == '@'; }

/// Line ends may be those of Windows; empty lines are none.
void append_names_in(const std::string& list, std::vector<std::string>& names) {
  const std::string text = read_text_file(list);
  if (text.find('\0') != std::string::npos) {
    throw Error(fmt::format("{}: holds a zero byte: expected names of inputs, one per line",
                            input_name(list)));
  }
  const std::size_t before = names.size();
  for (std::string_view rest = without_byte_order_mark(text); !rest.empty();) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!line.empty()) names.emplace_back(line);
  }
  if (names.size() == before) {
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

std::vector<std::string> input_names(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  bool list_is_standard_input = false;
  for (const std::string& word : words) {
    if (!is_list(word)) {
      names.push_back(word);
      continue;
    }
    if (word == "@-" && list_is_standard_input) {
      throw Error("@-: standard input is read twice: expected it once");
    }
    list_is_standard_input = list_is_standard_input || word == "@-";
    append_names_in(word.substr(1), names);
  }
  const auto reads = std::ranges::count(names, "-");
  if (list_is_standard_input && reads > 0) {
    throw Error("@- and -: standard input is read twice: expected it once");
  }
  if (reads > 1) throw Error("-: standard input is read twice: expected it once");
  return names;
}

CLI::Option& add_inputs(CLI::App& command, const char* name, std::vector<std::string>& inputs,
                        const std::string& what) {
  CLI::Option& option = *command.add_option(
      name, inputs,
      what + "; @FILE reads names from a file, one per line, and @- from standard input");
  option.type_name("FILE.draw|MESH");
  return *option.required();
}

}  // namespace displayfile
