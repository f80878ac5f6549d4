#include "displayfile/mesh/cad_import.h"

#include "displayfile/mesh/cad_format.h"
#include "displayfile/mesh/import_process.h"

namespace displayfile {

namespace {

constexpr ImportProgram kCadProgram{"displayfile-import-cad", "DISPLAYFILE_IMPORT_CAD_PROGRAM",
                                    "OpenCASCADE", "displayfile-cad"};

}  // namespace

Mesh read_by_cad_process(const std::string& path, bool with_normals, const ImportLimits& limits) {
  return read_by_program(kCadProgram, path, with_normals, limits);
}

std::vector<std::string> cad_extensions_read() { return cad_extensions(); }

}  // namespace displayfile
