#pragma once

#include <string>

namespace displayfile {

/// What --version prints: the project's version, which of the libraries that it can do without are
/// there, and the licence of this build.
std::string version();

const char* version_number();  ///< the project's alone, such as "1.2.3"

}  // namespace displayfile
