#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace displayfile {

/// A regular file opened for reading bytes, and its length, so that a reader can refuse a size that
/// the file cannot have before it allocates memory.
class BinaryInput {
 public:
  /// Throws Error, naming the file, if it cannot be read or is not a regular file.
  explicit BinaryInput(const std::filesystem::path& path);

  std::istream& stream() { return stream_; }
  std::uint64_t bytes_left();
  /// Throws Error "FILE: truncated" if the file is too short.
  void read(char* to, std::size_t bytes);
  /// Throws Error "FILE: what".
  [[noreturn]] void fail(std::string_view what) const;

 private:
  std::string name_;
  std::ifstream stream_;
  std::uint64_t bytes_ = 0;
};

}  // namespace displayfile
