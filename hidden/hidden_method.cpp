#include "hidden/hidden_method.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "clip/error.h"
#include "clip/nearest_word.h"

namespace displayfile {

namespace {

using enum HiddenMethod;
constexpr std::array kMethods{
    HiddenMethodEntry{automatic, "auto", true},
    HiddenMethodEntry{none, "none", true},
    HiddenMethodEntry{back_face, "back-face", true},
    HiddenMethodEntry{z_buffer, "z-buffer", true},
    HiddenMethodEntry{bsp, "bsp", true},
    HiddenMethodEntry{depth_sort, "depth-sort", true},
    HiddenMethodEntry{scan_line, "scan-line", true},
    HiddenMethodEntry{scan_line_z, "scan-line-z", true},
    HiddenMethodEntry{ray_cast, "ray-cast", true},
    HiddenMethodEntry{world_ray_cast, "world-ray-cast", true},
    HiddenMethodEntry{warnock, "warnock", true},
    HiddenMethodEntry{plain_z_buffer, "plain-z-buffer", true},
    HiddenMethodEntry{plain_z_buffer, "plain-z-buffer=float", true},
    HiddenMethodEntry{plain_z_buffer_16, "plain-z-buffer=16", true},
    HiddenMethodEntry{plain_z_buffer_24, "plain-z-buffer=24", true},
    HiddenMethodEntry{plain_z_buffer_32, "plain-z-buffer=32", true},
    HiddenMethodEntry{plain_z_buffer_double, "plain-z-buffer=double", true},
    HiddenMethodEntry{roberts, "roberts", true},
    HiddenMethodEntry{appel, "appel", true},
    HiddenMethodEntry{franklin, "franklin", true},
    HiddenMethodEntry{colour_rule, "colour-rule", false},
};

std::string available_names() {
  std::string names;
  for (const auto& entry : kMethods) {
    if (entry.available) names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  return names;
}

std::string meant_by(std::string_view name) {
  std::vector<std::string_view> available;
  for (const auto& entry : kMethods) {
    if (entry.available) available.push_back(entry.name);
  }
  return did_you_mean(name, available);
}

}  // namespace

std::span<const HiddenMethodEntry> hidden_methods() { return kMethods; }

HiddenMethod hidden_method(std::string_view name) {
  const auto entry = std::ranges::find(kMethods, name, &HiddenMethodEntry::name);
  if (entry == kMethods.end()) {
    throw Error("unknown hidden-surface method '" + std::string(name) + "':" + meant_by(name) +
                " expected one of " + available_names());
  }
  if (!entry->available) {
    throw Error("hidden-surface method '" + std::string(name) +
                "' is not in this version: expected one of " + available_names());
  }
  return entry->method;
}

std::string_view name_of(HiddenMethod method) {
  return std::ranges::find(kMethods, method, &HiddenMethodEntry::method)->name;
}

}  // namespace displayfile
