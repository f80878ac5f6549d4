#pragma once

#include <string>

namespace displayfile {

/// The text of --version: the project's version, the optional libraries present, and the licence of
/// this build.
std::string version();

const char* version_number();  ///< the project's alone, such as "1.2.3"

}  // namespace displayfile
