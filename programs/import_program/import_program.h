#pragma once

namespace displayfile {

/// What the program `displayfile-import` does with its arguments (displayfile/mesh/
/// import_protocol.h): reads one mesh by the import library, confined, for the process that waits
/// for it, answers on a pipe, and ends this process. Returns a status if it was called wrongly or
/// nobody waits.
int read_for_waiting_process(int argc, char** argv);

}  // namespace displayfile
