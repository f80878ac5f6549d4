#pragma once

#include <optional>
#include <string>

namespace displayfile {

/// What a file is that no reader takes, with its article: "a STEP file". Nothing if it may be one
/// that is read. The name's extension tells, of STEP also how the file begins; a building (IFC),
/// which is in the same notation, is not taken for STEP.
std::optional<std::string> format_not_read(const std::string& path);

}  // namespace displayfile
