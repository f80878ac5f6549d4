#pragma once

namespace displayfile {

/// What a process begins with: of its standard input, output and error those that are closed are
/// closed for whoever reads or writes them still, but no file that is opened takes their place, so
/// that no message is written into a picture.
void keep_standard_descriptors();

}  // namespace displayfile
