#pragma once

namespace displayfile {

/// Called at process start: standard input, output and error that are closed stay closed for
/// readers and writers, but no opened file takes their descriptors, so that no message is written
/// into a picture.
void keep_standard_descriptors();

}  // namespace displayfile
