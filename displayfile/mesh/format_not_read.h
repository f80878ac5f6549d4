#pragma once

#include <optional>
#include <string>

namespace displayfile {

/// A description of a file that no reader supports, with its article: "a STEP file". Nothing if it
/// may be readable. Decided by the extension, for STEP also by the beginning of the file; a
/// building (IFC), in the same notation, is not taken for STEP.
std::optional<std::string> format_not_read(const std::string& path);

}  // namespace displayfile
