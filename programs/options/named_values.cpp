#include "programs/options/named_values.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/looks/style.h"
#include "displayfile/mesh/mesh_file.h"
#include "interp/device/picture.h"
#include "interp/steps/steps.h"

namespace displayfile {

namespace {

/// The names of methods, then those of the colour rules of the methods that find surfaces.
std::vector<std::string> method_words() {
  std::vector<std::string> words;
  for (const HiddenMethodEntry& entry : hidden_methods()) {
    words.emplace_back(entry.name);
  }
  for (const HiddenMethodEntry& entry : hidden_methods()) {
    const bool is_first_name = name_of(entry.method) == entry.name;
    if (!is_first_name || shows_lines_only(entry.method)) continue;
    const auto rule = name_of(colour_rule_by(entry.method));
    if (rule != name_of(HiddenMethod::colour_rule)) words.emplace_back(rule);
  }
  return words;
}

std::vector<std::string> line_method_words() {
  std::vector<std::string> words;
  for (const HiddenMethodEntry& entry : hidden_methods()) {
    if (finds_lines(entry.method)) words.emplace_back(entry.name);
  }
  return words;
}

std::vector<std::string> line_kind_words() {
  std::vector<std::string> words;
  for (const LineKindEntry& entry : line_kinds()) words.emplace_back(entry.name);
  return words;
}

/// With those that have a style alone.
std::vector<std::string> styled_kind_words() {
  std::vector<std::string> words = line_kind_words();
  words.emplace_back(name_of(StyledLines::hidden));
  words.emplace_back(fmt::format("{}=", name_of(StyledLines::hatch)));
  return words;
}

std::vector<std::string> stepped_method_words() {
  std::vector<std::string> words;
  for (const HiddenMethod method : methods_with_steps()) words.emplace_back(name_of(method));
  for (const HiddenMethod form : plain_forms_with_steps()) words.emplace_back(name_of(form));
  return words;
}

constexpr std::array kNamedValues{NamedValues{"METHOD", method_words, nullptr},
                                  NamedValues{"STEPPED-METHOD", stepped_method_words, nullptr},
                                  NamedValues{"LINE-METHOD", line_method_words, nullptr},
                                  NamedValues{"KIND", line_kind_words, nullptr},
                                  NamedValues{"STYLED-KIND", styled_kind_words, nullptr},
                                  NamedValues{"PAPER", sheet_names, nullptr},
                                  NamedValues{"MESH", nullptr, mesh_extensions}};

}  // namespace

std::span<const NamedValues> named_values() { return kNamedValues; }

}  // namespace displayfile
