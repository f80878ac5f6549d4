#include "clip/base/module.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "clip/base/error.h"
#include "clip/base/shared_library.h"
#include "clip/system/own_files.h"

namespace displayfile {

std::vector<std::filesystem::path> places_of_companion(const char* name, const char* named) {
  if (named != nullptr) return {named};
  std::vector<std::filesystem::path> places;
  std::error_code unknown;
  const auto own = file_of_program(unknown);
  if (!unknown) {
    const auto folder = own.parent_path();
    places.push_back(folder / name);
    places.push_back((folder / DISPLAYFILE_COMPANIONS_FROM_PROGRAMS / name).lexically_normal());
  }
  const auto beside = file_of_this_code().parent_path() / name;
  if (beside.is_absolute() && std::ranges::find(places, beside) == places.end()) {
    places.push_back(beside);
  }
#ifdef DISPLAYFILE_COMPANIONS_BUILT
  places.push_back(std::filesystem::path(DISPLAYFILE_COMPANIONS_BUILT) / name);
#endif
  places.push_back(std::filesystem::path(DISPLAYFILE_COMPANIONS_INSTALLED) / name);
  return places;
}

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
