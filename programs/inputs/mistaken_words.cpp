#include "programs/inputs/mistaken_words.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile {

namespace {

namespace fs = std::filesystem;

bool is_a_path(const std::string& word) {
  std::error_code error;
  return fs::exists(word, error);
}

const CLI::Option* option_named(const CLI::App& command, const std::string& name) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->nonpositional() && option->check_name(name)) return option;
  }
  return nullptr;
}

/// The option that stands before a word, and its value so far.
struct Before {
  const CLI::Option* option = nullptr;
  std::string name, value;

  bool takes_value() const { return option->get_items_expected_max() > 0; }
};

Before option_in(const CLI::App& command, const std::string& word) {
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  return {option_named(command, name), name,
          equals == word.npos ? std::string() : word.substr(equals + 1)};
}

void refuse_if_value(const Before& before, const std::string& word) {
  if (before.option == nullptr || word.find_first_of("./") != word.npos || word.starts_with('@') ||
      is_a_path(word)) {
    return;
  }
  if (!before.takes_value()) {
    throw Error(
        fmt::format("{0} {1}: {0} takes no value, and there is no file {1}", before.name, word));
  }
  if (!before.option->get_type_name().ends_with(",...")) return;  // no list of values
  throw Error(
      fmt::format("{0} {1} {2}: there is no file {2}: expected commas between values: "
                  "{0} {1},{2}",
                  before.name, before.value, word));
}

}  // namespace

void require_no_folder_or_pattern(const std::string& input) {
  if (input == "-") return;
  std::error_code error;
  const fs::file_status status = fs::status(input, error);
  if (fs::is_directory(status)) {
    throw Error(fmt::format("{}: is a folder: expected drawing programs or meshes, such as {}",
                            input, (fs::path(input) / "*.draw").string()));
  }
  if (fs::exists(status) || input.find_first_of("*?[") == input.npos) return;
  throw Error(fmt::format(
      "{}: no such file, and no shell has expanded the pattern: expected it without quotation "
      "marks, and a file that it matches",
      input));
}

void require_no_mistaken_values(const CLI::App& command, std::span<char* const> words) {
  Before before;
  for (const std::string word : words) {
    if (word == "--") return;
    if (word.size() > 1 && word[0] == '-') {
      before = option_in(command, word);
    } else if (before.option != nullptr && before.takes_value() && before.value.empty()) {
      before.value = word;
    } else {
      refuse_if_value(before, word);
      before = {};
    }
  }
}

}  // namespace displayfile
