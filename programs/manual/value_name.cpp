#include "programs/manual/value_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace displayfile {

namespace {

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }

/// Removes the part before a separator outside braces from a text, and returns it.
std::string_view take_until(std::string_view& text, char separator) {
  int braces = 0;
  std::size_t end = 0;
  for (; end < text.size() && (braces > 0 || text[end] != separator); ++end) {
    if (text[end] == '{') ++braces;
    if (text[end] == '}') --braces;
  }
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

/// The extensions of NAME.ext or NAME.{ext,ext}; none of anything else.
std::vector<std::string> extensions_in(std::string_view name) {
  std::vector<std::string> extensions;
  const std::size_t dot = name.find('.');
  if (dot == name.npos) return extensions;
  std::string_view list = name.substr(dot + 1);
  if (list.starts_with('{') && list.ends_with('}')) list = list.substr(1, list.size() - 2);
  while (!list.empty()) extensions.emplace_back(take_until(list, ','));
  return extensions;
}

/// A word to be typed: without an optional suffix, and with the = before a required one.
std::string word_to_type(std::string_view word) {
  word = word.substr(0, word.find('['));
  const std::size_t equals = word.find('=');
  if (equals != word.npos && equals + 1 < word.size() && is_upper(word[equals + 1])) {
    word = word.substr(0, equals + 1);
  }
  return std::string(word);
}

void append_files(OfferedValues& offered, std::vector<std::string> extensions) {
  for (std::string& extension : extensions) {
    offered.extensions.push_back(extension.starts_with('.') ? extension.substr(1) : extension);
  }
  offered.files = true;
}

/// "INT in [1 - 16]" as words.
std::string range_text(std::string_view checked) {
  const std::size_t begin = checked.find('['), middle = checked.find(" - "),
                    end = checked.find(']');
  if (begin == checked.npos || middle == checked.npos || end == checked.npos) {
    return std::string(checked);
  }
  return fmt::format("{} to {}", checked.substr(begin + 1, middle - begin - 1),
                     checked.substr(middle + 3, end - middle - 3));
}

}  // namespace

ValueName value_name(const CLI::Option& option) {
  const std::string name = option.get_type_name();
  // A colon that is part of the name has no blank after it, unlike the check's: "A:B:INT in [1 -
  // 9]".
  const std::size_t blank = name.find(' ');
  const std::size_t colon = blank == name.npos ? name.npos : name.rfind(':', blank);
  if (colon == name.npos) return {name, ""};
  return {name.substr(0, colon), name.substr(colon + 1)};
}

std::string option_facts(const CLI::Option& option) {
  std::string facts;
  const ValueName value = value_name(option);
  if (!value.checked.empty()) facts += fmt::format("; {}", range_text(value.checked));
  if (!option.get_default_str().empty()) {
    facts += fmt::format("; {} if not given", option.get_default_str());
  }
  if (option.get_required()) facts += "; required";
  for (const CLI::Option* other : option.get_excludes()) {
    facts += fmt::format("; not with {}", other->get_name());
  }
  return facts;
}

OfferedValues offered_values(std::string_view value_name, std::span<const NamedValues> named) {
  constexpr std::string_view kSeveral = ",...";
  OfferedValues offered;
  offered.several = value_name.ends_with(kSeveral);
  if (offered.several) value_name.remove_suffix(kSeveral.size());
  bool any_file = false;
  while (!value_name.empty()) {
    const std::string_view one = take_until(value_name, '|');
    const auto known = std::ranges::find(named, one, &NamedValues::name);
    if (one == "FILE") any_file = true;
    if (one == "FOLDER") offered.folders = true;
    if (known != named.end()) {
      if (known->words != nullptr)
        std::ranges::move(known->words(), std::back_inserter(offered.words));
      if (known->extensions != nullptr) append_files(offered, known->extensions());
    } else if (auto extensions = extensions_in(one); !extensions.empty()) {
      append_files(offered, std::move(extensions));
    } else if (const auto first = one.find_first_not_of('-');
               first != one.npos && is_lower(one[first])) {
      offered.words.push_back(word_to_type(one));
    }
  }
  if (any_file) {
    offered.files = true;
    offered.extensions.clear();
  }
  return offered;
}

}  // namespace displayfile
