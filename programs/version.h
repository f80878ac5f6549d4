#pragma once

#include <string>

namespace displayfile {

/// What --version prints: the project's version, and which of the libraries that it can do without
/// are there.
std::string version();

}  // namespace displayfile
