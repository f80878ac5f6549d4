#pragma once

#include <string>

namespace displayfile {

/// The licence that this build as a whole is under, as SPDX names it, and why: one line, which
/// --version and the manual pages print. The source's is MIT; CGAL and dxflib, where they are in
/// the build, make it the GPL.
std::string licence_text();

}  // namespace displayfile
