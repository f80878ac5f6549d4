#pragma once

#include <filesystem>
#include <vector>

namespace displayfile {

/// Where a file of this build may stand that a program starts or loads when it needs it, in the
/// order in which to look: beside this program, where an installation has it, beside the shared
/// library that has this code, where it was built, and where it was to be installed. `named`, if
/// not null, is the only place: the user has set it.
std::vector<std::filesystem::path> places_of_companion(const char* name, const char* named);

}  // namespace displayfile
