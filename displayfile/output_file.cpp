#include "displayfile/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "clip/error.h"

namespace displayfile {

namespace {

namespace fs = std::filesystem;

constexpr int kNamesToTry = 1000;
constexpr std::size_t kLongestStem = 200;  // of a name of 255 bytes at most

bool may_write(const std::string& path) {
  return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

/// False, with the reason in errno, if not all could be written.
bool write_all(int descriptor, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(descriptor, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

/// A name beside the target, of this process.
std::string temporary_name(const fs::path& target, int attempt) {
  return (target.parent_path() / fmt::format(".{}.{}-{}{}",
                                             target.stem().string().substr(0, kLongestStem),
                                             ::getpid(), attempt, target.extension().string()))
      .string();
}

}  // namespace

void OutputFile::fail(const std::string& what) const { throw Error(path_ + ": " + what); }

void OutputFile::fail_to_write() const {
  fail(fmt::format("cannot be written: {}", std::strerror(errno)));
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(path_) {
  if (path_.empty()) throw Error("the output file has no name");
  std::error_code error;
  if (path_ == "-") {
    path_ = "standard output";
    if (::fcntl(STDOUT_FILENO, F_GETFD) < 0) fail_to_write();
    standard_output_ = true;
    target_ = (fs::temp_directory_path() / "displayfile").string();
    create_temporary();
    return;
  }
  const fs::file_status status = fs::status(path_, error);
  if (fs::is_directory(status)) fail("is a folder: expected a file name");
  if (fs::exists(status) && !may_write(path_)) fail_to_write();
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    direct_ = true;
    temporary_ = path_;
    return;
  }
  if (fs::is_symlink(fs::symlink_status(path_, error))) {
    if (const fs::path real = fs::weakly_canonical(path_, error); !error) target_ = real.string();
  }
  create_temporary();
  if (fs::exists(status)) fs::permissions(temporary_, status.permissions(), error);
}

void OutputFile::create_temporary() {
  for (int attempt = 0; attempt < kNamesToTry; ++attempt) {
    temporary_ = temporary_name(target_, attempt);
    unfinished_ = UnfinishedPath(temporary_);
    const int descriptor =
        ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);  // less umask
    if (descriptor >= 0) {
      ::close(descriptor);
      pending_ = true;
      return;
    }
    const fs::path folder = fs::path(target_).parent_path();
    if (errno == ENOENT && !folder.empty()) {
      fail(fmt::format("cannot be written: there is no folder {}", folder.string()));
    }
    if (errno != EEXIST) fail_to_write();
  }
  fail("cannot be written: every temporary name beside it is taken");
}

OutputFile::~OutputFile() { remove_temporary(); }

void OutputFile::remove_temporary() {
  if (!pending_) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  unfinished_ = {};
  pending_ = false;
}

std::ostream& OutputFile::stream() {
  if (!stream_.is_open()) {
    stream_.open(temporary_, std::ios::binary | std::ios::trunc);
    if (!stream_) fail_to_write();
  }
  return stream_;
}

void OutputFile::commit() {
  if (stream_.is_open()) {
    errno = 0;
    stream_.close();  // sets failbit if a buffered write fails, and keeps an earlier one
    if (!stream_) {
      const int reason = errno;
      remove_temporary();
      fail(fmt::format("not all could be written{}{}", reason != 0 ? ": " : "",
                       reason != 0 ? std::strerror(reason) : ""));
    }
  }
  if (direct_) return;
  if (standard_output_) return copy_to_standard_output();
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) {
    remove_temporary();
    fail("cannot be replaced: " + error.message());
  }
  unfinished_ = {};
  pending_ = false;
}

/// The temporary file is removed before the first byte is written: a reader that goes away may end
/// this process.
void OutputFile::copy_to_standard_output() {
  std::cout.flush();
  const int from = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (from < 0) fail_to_write();
  remove_temporary();
  std::array<char, 1 << 16> block;
  ssize_t count = 0;
  bool written = true;
  while (written && (count = ::read(from, block.data(), block.size())) > 0) {
    written = write_all(STDOUT_FILENO, block.data(), static_cast<std::size_t>(count));
  }
  const int reason = errno;
  ::close(from);
  errno = reason;
  if (!written || count < 0) fail_to_write();
}

}  // namespace displayfile
