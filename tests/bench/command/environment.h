#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace displayfile::bench {

/// The environment of the measurements, as names and values: the day (UTC), version, compiler,
/// flags, processor, system, and the packages as they were when this was configured and as they are
/// now.
std::vector<std::pair<std::string, std::string>> environment();

/// Different for different executables and processors.
std::string build_identity();

/// FNV-1a over a file's bytes, in hexadecimal. Throws Error if it cannot be read.
std::string file_hash(const std::string& path);

}  // namespace displayfile::bench
