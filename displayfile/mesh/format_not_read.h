#pragma once

#include <optional>
#include <string>

namespace displayfile {

/// A description of a file that no reader supports, with its article: "a DWG drawing". Nothing if
/// it may be readable. Decided by the extension.
std::optional<std::string> format_not_read(const std::string& path);

/// Throws Error unless the file's format may be read where the import library has no confined
/// process: its reader has survived all mutants of tests/fuzz (mutate_models) without a crash or
/// excessive memory so far. That is no proof.
void require_allowed_format(const std::string& path);

}  // namespace displayfile
