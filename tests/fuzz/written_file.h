#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace displayfile::fuzz {

/// A file of this process that holds the bytes, for readers that take a path; the next call with
/// the same extension replaces it.
inline std::string written_file(std::span<const std::uint8_t> bytes, const std::string& extension) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("displayfile_fuzz." + std::to_string(::getpid()) + "." + extension);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  return path.string();
}

}  // namespace displayfile::fuzz
