#pragma once

#include <string>

namespace displayfile {

/// The whole content of a text file; "-" is standard input. Throws Error, naming the file and
/// the reason, if it cannot be read. Reading stops at the first block that holds a zero byte:
/// such a file is not text, and its reader says so without having read gigabytes.
std::string read_text_file(const std::string& path);

/// How messages name the file: its path, or "standard input" for "-".
std::string input_name(const std::string& path);

}  // namespace displayfile
