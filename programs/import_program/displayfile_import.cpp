// The program `displayfile-import`. Only displayfile starts it
// (displayfile/mesh/import_process.md).

#include "clip/system/descriptors.h"
#include "programs/import_program/import_program.h"
#include "programs/process/exit_status.h"

int main(int argc, char** argv) {
  displayfile::keep_standard_descriptors();
  return displayfile::exit_status(displayfile::read_for_waiting_process, argc, argv);
}
