#include "programs/inputs/output_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "clip/base/error.h"
#include "clip/base/nearest_word.h"

namespace displayfile {

namespace {

namespace fs = std::filesystem;

struct Input {
  const std::string& path;
  std::size_t k, inputs;
  bool first;  ///< nothing stands before the field
};

/// A part of a path that leads elsewhere.
bool is_no_name(const fs::path& part) { return part == "." || part == ".."; }

std::string name(const Input& input) {
  if (input.path == "-") return "stdin";
  const std::string stem = fs::path(input.path).stem().string();
  return is_no_name(stem) ? fs::path(input.path).filename().string() : stem;
}

std::string extension(const Input& input) {
  const std::string dotted = fs::path(input.path).extension().string();
  return dotted.empty() ? dotted : dotted.substr(1);
}

std::string folder(const Input& input) {
  const fs::path as_given = fs::path(input.path).parent_path();
  const fs::path kept = input.first ? as_given : folder_within(input.path);
  return kept.empty() ? "." : kept.string();
}

std::string number(const Input& input) {
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(input.inputs - 1).size());
  return fmt::format("{:0{}}", input.k, digits);
}

struct Field {
  std::string_view name;
  std::string (*value)(const Input&);
};
constexpr std::array kFields{Field{"name", name}, Field{"ext", extension}, Field{"folder", folder},
                             Field{"number", number}};

const Field& field_of(std::string_view pattern, std::string_view field) {
  std::array<std::string_view, kFields.size()> names;
  std::ranges::transform(kFields, names.begin(), &Field::name);
  const auto found = std::ranges::find(kFields, field, &Field::name);
  if (found != kFields.end()) return *found;
  throw Error(fmt::format(
      "{}: unknown field '{{{}}}':{} expected {{name}}, {{ext}}, {{folder}} or {{number}}", pattern,
      field, did_you_mean(field, names)));
}

/// An input without an extension leaves no dot where that would stand, and no folder without a
/// name.
void append(const std::string& value, std::string& made) {
  if (!value.empty()) {
    made += value;
  } else if (made.empty() || made.ends_with('/')) {
    made += '.';
  } else if (made.ends_with('.')) {
    made.pop_back();
  }
}

}  // namespace

bool has_field(std::string_view text) {
  return std::ranges::any_of(kFields, [&](const Field& field) {
    return text.find(fmt::format("{{{}}}", field.name)) != text.npos;
  });
}

bool is_name_pattern(std::string_view text) {
  return text.find_first_of("{}") != std::string_view::npos;
}

std::string output_name(std::string_view pattern, const std::string& input, std::size_t k,
                        std::size_t inputs) {
  std::string made;
  for (std::size_t i = 0; i < pattern.size();) {
    const char c = pattern[i++];
    if (c != '{' && c != '}') {
      made += c;
      continue;
    }
    if (i < pattern.size() && pattern[i] == c) {
      made += c;
      ++i;
      continue;
    }
    const std::size_t end = c == '{' ? pattern.find_first_of("{}", i) : std::string_view::npos;
    if (end == std::string_view::npos || pattern[end] != '}') {
      throw Error(fmt::format("{}: a brace by itself: expected a field such as {{name}}, or {}{}",
                              pattern, c, c));
    }
    const Field& field = field_of(pattern, pattern.substr(i, end - i));
    append(field.value({input, k, inputs, made.empty()}), made);
    i = end + 1;
  }
  return made;
}

fs::path folder_before_fields(std::string_view pattern) {
  std::size_t field = 0;
  while (field < pattern.size() && (pattern[field] != '{' || pattern.substr(field, 2) == "{{")) {
    field += pattern[field] == '{' ? 2 : 1;
  }
  const std::size_t slash = pattern.substr(0, field).rfind('/');
  if (slash == std::string_view::npos) return {};
  return output_name(pattern.substr(0, slash + 1), "", 0, 1);
}

fs::path folder_within(const std::string& input) {
  fs::path kept;
  for (const fs::path& part : fs::path(input).parent_path().lexically_normal().relative_path()) {
    if (!is_no_name(part)) kept /= part;
  }
  return kept;
}

}  // namespace displayfile
