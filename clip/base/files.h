#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

namespace displayfile {

/// The whole content of a text file; "-" is standard input. Throws Error, naming the file and
/// the reason, if it cannot be read. Reading stops at the first block that holds a zero byte:
/// such a file is not text, and its reader says so without having read gigabytes.
std::string read_text_file(const std::string& path);

/// How messages name the file: its path, or "standard input" for "-".
std::string input_name(const std::string& path);

/// A path's extension with its dot, in lower case (ASCII letters only). Empty if there is none.
inline std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

/// The absolute path after following symbolic links, including links to files that do not exist
/// yet. Empty, with the error, if it cannot be found, as for circular links.
std::filesystem::path real_path(const std::filesystem::path& path, std::error_code& error);

}  // namespace displayfile
