#include "clip/base/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile {

namespace {

constexpr std::size_t kBytesPerRead = std::size_t{1} << 20;
/// The file system's report of a file's size is trusted up to here.
constexpr std::uintmax_t kMostAtOnce = std::uintmax_t{1} << 30;

struct Close {
  void operator()(std::FILE* file) const {
    if (file != stdin) std::fclose(file);
  }
};

[[noreturn]] void fail(const std::string& path) {
  throw Error(fmt::format("{}: cannot be read: {}", input_name(path), std::strerror(errno)));
}

}  // namespace

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string read_text_file(const std::string& path) {
  // Opening a pipe without a writer would block forever.
  std::error_code unknown;
  if (path != "-" && std::filesystem::is_fifo(path, unknown)) {
    throw Error(path + ": not a regular file: expected one, or - for standard input");
  }
  const std::unique_ptr<std::FILE, Close> file(path == "-" ? stdin
                                                           : std::fopen(path.c_str(), "rb"));
  if (!file) fail(path);
  std::string text;
  const std::uintmax_t size = path == "-" ? 0 : std::filesystem::file_size(path, unknown);
  // One byte more than a small file has, so that one read finds its end.
  const std::size_t read_at_once =
      unknown || path == "-"
          ? kBytesPerRead
          : static_cast<std::size_t>(std::clamp<std::uintmax_t>(size + 1, 4096, kBytesPerRead));
  if (!unknown) {
    text.reserve(static_cast<std::size_t>(std::min<std::uintmax_t>(size, kMostAtOnce)) +
                 read_at_once);
  }
  for (std::size_t used = 0;;) {
    text.resize(used + read_at_once);
    const std::size_t count = std::fread(text.data() + used, 1, read_at_once, file.get());
    if (std::ferror(file.get()) != 0) fail(path);
    const bool binary = std::memchr(text.data() + used, 0, count) != nullptr;
    used += count;
    if (count < read_at_once || binary) {
      text.resize(used);
      return text;
    }
  }
}

namespace fs = std::filesystem;

fs::path real_path(const fs::path& path, std::error_code& error) {
  constexpr int kMostLinks = 40;  // the system's own limit
  fs::path followed = fs::absolute(path, error);
  for (int links = 0; !error && links < kMostLinks; ++links) {
    followed = fs::weakly_canonical(followed, error);
    if (error) break;
    // weakly_canonical does not follow links to files that do not exist.
    std::error_code not_there;
    if (!fs::is_symlink(fs::symlink_status(followed, not_there))) return followed;
    followed = followed.parent_path() / fs::read_symlink(followed, error);
  }
  if (!error) error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
  return {};
}

}  // namespace displayfile
