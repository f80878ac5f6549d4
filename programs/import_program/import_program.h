#pragma once

namespace displayfile {

/// The program `displayfile-import`, with its arguments (displayfile/mesh/import_protocol.h): reads
/// one mesh by the import library, confined, for the waiting process, replies on a pipe, and ends
/// this process. Returns a status if it was called wrongly or no process waits.
int read_for_waiting_process(int argc, char** argv);

}  // namespace displayfile
