#pragma once

#include <string>
#include <vector>

namespace displayfile {

/// The extensions that read_mesh supports, with their dots, in alphabetical order. Loads the import
/// library.
std::vector<std::string> mesh_extensions();

}  // namespace displayfile
