#pragma once

#include <string>

namespace displayfile {

/// Throws Error unless the file's format may be read where the import library has no confined
/// process: its reader has survived all mutants of tests/fuzz (mutate_models) without a crash or
/// excessive memory so far. That is no proof.
void require_allowed_format(const std::string& path);

}  // namespace displayfile
