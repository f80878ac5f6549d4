#include "clip/base/companion_file.h"

#include <dlfcn.h>

#include <algorithm>
#include <system_error>

namespace displayfile {

namespace {

/// The folder of the program or shared library that this code is in; empty if it is not known.
std::filesystem::path folder_of_this_code() {
  Dl_info found{};
  static const char here = 0;
  if (dladdr(&here, &found) == 0 || found.dli_fname == nullptr) return {};
  return std::filesystem::path(found.dli_fname).parent_path();
}

}  // namespace

std::vector<std::filesystem::path> places_of_companion(const char* name, const char* named) {
  if (named != nullptr) return {named};
  std::vector<std::filesystem::path> places;
  std::error_code unknown;
  const auto own = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (!unknown) {
    const auto folder = own.parent_path();
    places.push_back(folder / name);
    places.push_back((folder / DISPLAYFILE_COMPANIONS_FROM_PROGRAMS / name).lexically_normal());
  }
  const auto beside = folder_of_this_code() / name;
  if (beside.is_absolute() && std::ranges::find(places, beside) == places.end()) {
    places.push_back(beside);
  }
#ifdef DISPLAYFILE_COMPANIONS_BUILT
  places.push_back(std::filesystem::path(DISPLAYFILE_COMPANIONS_BUILT) / name);
#endif
  places.push_back(std::filesystem::path(DISPLAYFILE_COMPANIONS_INSTALLED) / name);
  return places;
}

}  // namespace displayfile
