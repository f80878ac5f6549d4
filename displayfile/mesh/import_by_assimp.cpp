#include "displayfile/mesh/import_process.h"

namespace displayfile {

namespace {

constexpr ImportProgram kAssimpProgram{"displayfile-import", "DISPLAYFILE_IMPORT_PROGRAM", "Assimp",
                                       "displayfile"};

}  // namespace

Mesh read_by_import_process(const std::string& path, bool with_normals,
                            const ImportLimits& limits) {
  return read_by_program(kAssimpProgram, path, with_normals, limits);
}

}  // namespace displayfile
