#include "clip/base/module.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "clip/base/companion_file.h"
#include "clip/base/error.h"
#include "clip/base/shared_library.h"

namespace displayfile {

namespace {

std::filesystem::path place_of(const std::string& file, std::string_view purpose) {
  std::string named;
  if (const char* folder = std::getenv("DISPLAYFILE_MODULES")) {
    named = (std::filesystem::path(folder) / file).string();
  }
  std::string looked_at;
  for (const auto& place :
       places_of_companion(file.c_str(), named.empty() ? nullptr : named.c_str())) {
    std::error_code unknown;
    if (std::filesystem::exists(place, unknown)) return place;
    looked_at += (looked_at.empty() ? "" : ", ") + place.string();
  }
  throw Error(
      fmt::format("{} needs the module {}, which is not installed: it was looked for as {}; the "
                  "environment's DISPLAYFILE_MODULES names its folder",
                  purpose, file, looked_at));
}

}  // namespace

const void* load_module(std::string_view name, std::string_view purpose) {
  const std::string file = fmt::format("{}.so.{}", name, DISPLAYFILE_MODULE_VERSION);
  const std::filesystem::path place = place_of(file, purpose);
  try {
    const SharedLibrary library(place.string().c_str());
    const void* const found = library.function<const void* (*)()>("displayfile_module")();
    const std::string_view version = *static_cast<const char* const*>(found);
    if (version == DISPLAYFILE_MODULE_VERSION) return found;
    throw Error(fmt::format("{}: expected a module of this version, {}: it is of {}",
                            place.string(), DISPLAYFILE_MODULE_VERSION, version));
  } catch (const Error& error) {
    throw Error(fmt::format("{} needs the module {}: {}", purpose, file, error.what()));
  }
}

}  // namespace displayfile
