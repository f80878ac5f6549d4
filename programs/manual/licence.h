#pragma once

#include <string>

namespace displayfile {

/// One line for --version and the manual pages: the licence of this build, which is the source's,
/// and those of the modules that were built, as SPDX names them.
std::string licence_text();

}  // namespace displayfile
