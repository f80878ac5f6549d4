// The program `displayfile-import-cad`. Only displayfile starts it
// (displayfile/mesh/import_process.md).

#include "clip/system/descriptors.h"
#include "displayfile/mesh/cad/cad_file.h"
#include "programs/import_program/import_program.h"
#include "programs/process/exit_status.h"

namespace {

int read_cad_for_waiting_process(int argc, char** argv) {
  using namespace displayfile;
  return read_for_waiting_process(argc, argv, {load_cad_library, read_cad_file});
}

}  // namespace

int main(int argc, char** argv) {
  displayfile::keep_standard_descriptors();
  return displayfile::exit_status(read_cad_for_waiting_process, argc, argv);
}
