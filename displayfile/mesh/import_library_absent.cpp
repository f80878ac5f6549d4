#include "clip/base/error.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/import_process.h"

namespace displayfile {

Mesh read_by_import_library(const std::string& path, bool) {
  throw Error(path + ": built without the import library (Assimp): expected OBJ, OFF, PLY or STL");
}

Mesh read_by_import_process(const std::string& path, bool with_normals, const ImportLimits&) {
  return read_by_import_library(path, with_normals);
}

std::optional<std::string> import_library_version() { return std::nullopt; }
std::vector<std::string> import_library_extensions() { return {}; }

}  // namespace displayfile
