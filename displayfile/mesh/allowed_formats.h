#pragma once

#include <string>

namespace displayfile {

/// Throws Error unless the file's extension is that of a format which may be read where the import
/// library has no process of its own with limits: one whose reader no mutant of tests/fuzz
/// (mutate_models) has crashed or made hungry so far. That is no proof.
void require_allowed_format(const std::string& path);

}  // namespace displayfile
