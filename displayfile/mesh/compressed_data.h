#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace displayfile {

/// True if data begin as those compressed by gzip (RFC 1952) or Zstandard (RFC 8878).
bool begins_compressed(std::string_view beginning);

/// The name without .gz or .zst, in either case; other names are unchanged.
std::filesystem::path name_uncompressed(const std::filesystem::path& path);

/// The content of a compressed file; several compressed parts in a row are one content. The
/// libraries are loaded on first use. Throws Error, naming the path: the data are damaged or cut
/// off, or expand to more than 256 times their size and 64 MiB; the library is not built in or not
/// installed.
std::string uncompressed(const std::string& path, std::string_view data);

/// Collects content that is being expanded, within the limits of `uncompressed`.
class ExpandedData {
 public:
  ExpandedData(const std::string& path, std::size_t compressed_bytes);

  /// Free room after the kept content.
  struct Room {
    char* data;
    std::size_t bytes;
  };
  Room room();
  /// Keeps the first `bytes` of the room.
  void keep(std::size_t bytes) { kept_ += bytes; }
  std::string take() &&;

  [[noreturn]] void fail(std::string_view library, std::string_view what) const;

 private:
  const std::string& path_;
  std::size_t most_, kept_ = 0;
  std::string content_;
};

/// `uncompressed` by zlib and by libzstd.
std::string uncompressed_gzip(const std::string& path, std::string_view data);
std::string uncompressed_zstd(const std::string& path, std::string_view data);

}  // namespace displayfile
