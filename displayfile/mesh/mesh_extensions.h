#pragma once

#include <string>
#include <vector>

namespace displayfile {

/// Of the files that read_mesh takes by their names, with their dots, in alphabetical order. The
/// import library is loaded to say what it reads.
std::vector<std::string> mesh_extensions();

}  // namespace displayfile
