#include "programs/options/picture_words.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "interp/draw/draw.h"

namespace displayfile {

namespace {

/// The names without their first `skipped` characters.
std::vector<std::string_view> names_of(std::span<const Choice> choices, std::size_t skipped) {
  std::vector<std::string_view> names;
  for (const Choice& choice : choices) names.push_back(choice.name.substr(skipped));
  return names;
}

}  // namespace

std::string picture_file() {
  return fmt::format("OUT.{{{}}}", fmt::join(names_of(picture_formats(), 1), ","));
}
std::string picture_format_words() {
  return fmt::format("{}", fmt::join(names_of(picture_formats(), 1), "|"));
}
std::string raster_device_words() {
  return fmt::format("{}", fmt::join(names_of(raster_devices(), 0), "|"));
}

}  // namespace displayfile
