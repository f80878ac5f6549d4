#pragma once

namespace displayfile {

/// Called at process start: standard input, output and error that are closed stay closed for
/// readers and writers, but no opened file takes their descriptors, so that no message is written
/// into a picture. Bytes and ends of lines pass through all three as they are.
void keep_standard_descriptors();

/// True if standard error is a terminal on which a line can be written over.
bool errors_are_on_terminal();

}  // namespace displayfile
