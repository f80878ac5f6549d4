#include "clip/surfaces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/nearest_word.h"

namespace displayfile {

namespace {

using enum HiddenMethod;
constexpr std::array kMethods{
    HiddenMethodEntry{automatic, "auto"},
    HiddenMethodEntry{none, "none"},
    HiddenMethodEntry{back_face, "back-face"},
    HiddenMethodEntry{z_buffer, "z-buffer"},
    HiddenMethodEntry{bsp, "bsp"},
    HiddenMethodEntry{depth_sort, "depth-sort"},
    HiddenMethodEntry{map, "map"},
    HiddenMethodEntry{scan_line, "scan-line"},
    HiddenMethodEntry{scan_line_z, "scan-line-z"},
    HiddenMethodEntry{ray_cast, "ray-cast"},
    HiddenMethodEntry{world_ray_cast, "world-ray-cast"},
    HiddenMethodEntry{warnock, "warnock"},
    HiddenMethodEntry{plain_z_buffer, "plain-z-buffer"},
    HiddenMethodEntry{plain_z_buffer, "plain-z-buffer=float"},
    HiddenMethodEntry{plain_z_buffer_16, "plain-z-buffer=16"},
    HiddenMethodEntry{plain_z_buffer_24, "plain-z-buffer=24"},
    HiddenMethodEntry{plain_z_buffer_32, "plain-z-buffer=32"},
    HiddenMethodEntry{plain_z_buffer_double, "plain-z-buffer=double"},
    HiddenMethodEntry{plain_scan_line, "plain-scan-line"},
    HiddenMethodEntry{plain_warnock, "plain-warnock"},
    HiddenMethodEntry{plain_bsp, "plain-bsp"},
    HiddenMethodEntry{roberts, "roberts"},
    HiddenMethodEntry{appel, "appel"},
    HiddenMethodEntry{franklin, "franklin"},
    HiddenMethodEntry{perimeter, "perimeter"},
    HiddenMethodEntry{plain_appel, "plain-appel"},
    HiddenMethodEntry{colour_rule, "colour-rule"},
};
constexpr std::string_view kColourRuleBy = "colour-rule=";

bool is_any(const HiddenMethodEntry&) { return true; }
bool is_of_surfaces(const HiddenMethodEntry& entry) { return !shows_lines_only(entry.method); }

/// The method of that name among the allowed ones; throws Error for any other name. `whose`
/// precedes the name in the message.
HiddenMethod method_among(bool (*may_be)(const HiddenMethodEntry&), std::string_view name,
                          std::string_view whose) {
  std::vector<std::string_view> known;
  std::string names;
  for (const auto& entry : kMethods) {
    if (!may_be(entry)) continue;
    known.push_back(entry.name);
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  const auto entry = std::ranges::find(kMethods, name, &HiddenMethodEntry::name);
  if (entry != kMethods.end() && may_be(*entry)) return entry->method;
  const std::string quoted = std::string(whose) + "'" + std::string(name) + "'";
  if (entry == kMethods.end()) {
    throw Error("unknown hidden-surface method " + quoted + ":" + did_you_mean(name, known) +
                " expected one of " + names);
  }
  throw Error("hidden-surface method " + quoted + " finds no surfaces: expected one of " + names);
}

/// The names of the colour rules, by the methods of surfaces.
std::vector<std::string> colour_rule_names() {
  std::vector<std::string> names{std::string(name_of(colour_rule))};
  for (int surfaces = 1; surfaces < static_cast<int>(colour_rule); ++surfaces) {
    names.push_back(std::string(kColourRuleBy) +
                    std::string(name_of(static_cast<HiddenMethod>(surfaces))));
  }
  return names;
}

}  // namespace

std::span<const HiddenMethodEntry> hidden_methods() { return kMethods; }

HiddenMethod hidden_method(std::string_view name) {
  if (!name.starts_with(kColourRuleBy)) return method_among(is_any, name, "");
  return colour_rule_by(
      method_among(is_of_surfaces, name.substr(kColourRuleBy.size()), "of the colour rule "));
}

std::string_view name_of(HiddenMethod method) {
  if (method > colour_rule) {
    static const std::vector<std::string> names = colour_rule_names();
    return names[static_cast<std::size_t>(surfaces_of(method))];
  }
  return std::ranges::find(kMethods, method, &HiddenMethodEntry::method)->name;
}

}  // namespace displayfile
