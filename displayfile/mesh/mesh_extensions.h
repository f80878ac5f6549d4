#pragma once

#include <string>
#include <vector>

namespace displayfile {

/// The extensions of the files that read_mesh takes, with their dots, in alphabetical order. The
/// import library is loaded to say what it reads.
std::vector<std::string> mesh_extensions();

}  // namespace displayfile
