#include "displayfile/mesh/import_library.h"
#include "programs/import_program/import_program.h"

namespace displayfile {

namespace {

Mesh read_by_assimp(const std::string& path, bool with_normals, double) {
  return read_by_import_library(path, with_normals);
}

}  // namespace

int read_for_waiting_process(int argc, char** argv) {
  return read_for_waiting_process(argc, argv, {load_import_library, read_by_assimp});
}

}  // namespace displayfile
