#include "clip/base/companion_file.h"

#include <algorithm>
#include <system_error>

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

}  // namespace displayfile
