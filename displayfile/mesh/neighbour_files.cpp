#include "displayfile/mesh/neighbour_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile {

NeighbourFiles::NeighbourFiles(const std::string& mesh) {
  std::error_code failure;
  mesh_ = std::filesystem::canonical(mesh, failure);
  if (!failure) {
    const auto folder = std::filesystem::path(mesh).parent_path();
    folder_ = std::filesystem::canonical(folder.empty() ? "." : folder, failure);
  }
  if (failure) throw Error(fmt::format("{}: no such file: expected a mesh", mesh));
}

bool NeighbourFiles::allows(const std::string& path) const {
  std::error_code failure;
  const auto file = std::filesystem::canonical(path, failure);
  if (failure || !std::filesystem::is_regular_file(file, failure)) return false;
  return file == mesh_ ||
         std::mismatch(folder_.begin(), folder_.end(), file.begin(), file.end()).first ==
             folder_.end();
}

}  // namespace displayfile
