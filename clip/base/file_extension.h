#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

namespace displayfile {

/// A path's extension with its dot, in lower case (ASCII letters only). Empty if there is none.
inline std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return extension;
}

}  // namespace displayfile
