#pragma once

#include <string>

namespace displayfile {

/// Throws Error unless the file's extension is that of a format whose reader in the import library
/// has never crashed, hung or asked for memory without need in the mutations of tests/fuzz
/// (mutate_models), and which may be read where the library has no process of its own with limits.
void require_allowed_format(const std::string& path);

}  // namespace displayfile
