#include "clip/error.h"
#include "displayfile/mesh/import_library.h"

namespace displayfile {

Mesh read_by_import_library(const std::string& path, bool) {
  throw Error(path + ": built without the import library (Assimp): expected OBJ, OFF, PLY or STL");
}

std::optional<std::string> import_library_version() { return std::nullopt; }

}  // namespace displayfile
