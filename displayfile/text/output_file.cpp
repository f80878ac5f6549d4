#include "displayfile/text/output_file.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/system/descriptors.h"
#include "clip/system/own_files.h"

namespace displayfile {

namespace {

namespace fs = std::filesystem;

constexpr int kNamesToTry = 1000;
constexpr std::size_t kLongestStem = 200;  // of a name of 255 bytes at most

/// A name beside the target, unique to this process.
std::string temporary_name(const fs::path& target, int attempt) {
  return (target.parent_path() /
          fmt::format(".{}.{}-{}{}", target.stem().string().substr(0, kLongestStem),
                      number_of_process(), attempt, target.extension().string()))
      .string();
}

/// The message that there is no folder for temporary files: one of these variables names it, or it
/// is /tmp.
std::string no_temporary_folder() {
  for (const char* variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"}) {
    if (const char* const folder = std::getenv(variable)) {
      return fmt::format("{} names {}, which is no folder: expected one for temporary files",
                         variable, folder);
    }
  }
  return "/tmp is no folder: expected one for temporary files";
}

}  // namespace

/// True for the names of standard output. A file that such a name leads to would be replaced, and
/// data written there later would not be in it.
bool is_standard_output(const std::string& path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

void OutputFile::fail(const std::string& what) const { throw Error(path_ + ": " + what); }

void OutputFile::fail_to_write() const {
  const int reason = errno;
  const fs::path folder = fs::path(target_).parent_path();
  std::error_code error;
  if (reason == ENOENT && !folder.empty() && !fs::exists(folder, error)) {
    fail(fmt::format("cannot be written: there is no folder {}", folder.string()));
  }
  fail(fmt::format("cannot be written: {}", std::strerror(reason)));
}

/// Removes the temporary file before it throws; reason 0: none.
void OutputFile::fail_at_the_end(const std::string& what, int reason) {
  remove_temporary();
  fail(fmt::format("{}{}{}", what, reason != 0 ? ": " : "",
                   reason != 0 ? std::strerror(reason) : ""));
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(path_) {
  if (path_.empty()) throw Error("the output file has no name");
  std::error_code error;
  if (is_standard_output(path_)) {
    path_ = "standard output";
    if (!can_write(standard_output())) fail_to_write();
    standard_output_ = true;
    create_to_be_copied();
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
    target_ = real_path(path_, error).string();
    if (error) fail("cannot be written: " + error.message());
  }
  create_temporary();
  if (fs::exists(status)) set_permissions(descriptor_, status.permissions());
}

// ---- The temporary file -------------------------------------------------------------------------

void OutputFile::create_to_be_copied() {
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (error) fail("cannot be written: " + no_temporary_folder());
  target_ = (folder / "displayfile").string() + fs::path(target_).extension().string();
  copied_ = true;
  create_temporary();
}

/// Creates the temporary file, without a name where the file system supports that.
void OutputFile::create_temporary() {
  descriptor_ = create_nameless_file(fs::path(target_).parent_path(), temporary_);
  if (descriptor_ >= 0) return;
  create_named([&] {
    descriptor_ = create_file(temporary_);
    return descriptor_ >= 0;
  });
}

/// Tries one name after another; `create` returns true on success, and otherwise sets errno.
template <class Create>
void OutputFile::create_named(const Create& create) {
  const UnfinishedPath::Naming naming;
  for (int attempt = 0; attempt < kNamesToTry; ++attempt) {
    temporary_ = temporary_name(target_, attempt);
    unfinished_ = UnfinishedPath(temporary_);
    if (create()) {
      pending_ = true;
      return;
    }
    const int reason = errno;
    unfinished_ = {};
    errno = reason;
    if (reason != EEXIST) fail_to_write();
  }
  fail("cannot be written: every temporary name beside it is taken");
}

void OutputFile::name_temporary() {
  create_named([&] { return name_nameless_file(descriptor_, temporary_); });
}

const std::string& OutputFile::temporary_path() {
  // A library may read what it wrote before.
  if (std::exchange(direct_, false)) create_to_be_copied();
  if (!pending_) name_temporary();
  return temporary_;
}

OutputFile::~OutputFile() { remove_temporary(); }

void OutputFile::close() {
  if (descriptor_ >= 0) close_file(std::exchange(descriptor_, -1));
}

void OutputFile::remove_temporary() {
  close();
  if (!pending_) return;
  const UnfinishedPath::Naming naming;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  unfinished_ = {};
  pending_ = false;
}

std::ostream& OutputFile::stream() {
  if (blocks_ == nullptr) {
    if (direct_) descriptor_ = open_emptied(path_);
    if (descriptor_ < 0) fail_to_write();
    blocks_ = std::make_unique<BlockBuffer>(descriptor_);
    stream_.rdbuf(blocks_.get());
  }
  return stream_;
}

// ---- The end ------------------------------------------------------------------------------------

void OutputFile::finish() {
  if (finished_) return;
  if (blocks_ != nullptr) {
    stream_.flush();
    if (!stream_) fail_at_the_end("not all could be written", blocks_->reason());
  }
  finished_ = true;
  if (direct_ || copied_) return;
  if (!put_on_disk(descriptor_)) fail_at_the_end("not all could be put on the disk", errno);
}

void OutputFile::commit() {
  finish();
  if (direct_) return remove_temporary();  // nothing but the descriptor
  if (copied_) return copy_to_target();
  replace_target();
  close();
  if (!put_names_on_disk(fs::path(target_).parent_path())) {
    fail(fmt::format("is written, but its name may not be on the disk: {}", std::strerror(errno)));
  }
}

void OutputFile::replace_target() {
  const UnfinishedPath::Naming naming;
  if (!pending_ && link_to_target()) return;
  if (!pending_) name_temporary();
  close();  // Windows renames no open file
  if (!rename_file(temporary_, target_)) {
    const int reason = errno;
    std::error_code error;
    const fs::path folder = fs::path(target_).parent_path();
    if (reason == ENOENT && !folder.empty() && !fs::exists(folder, error)) {
      fail_at_the_end("cannot be written: there is no folder " + folder.string(), 0);
    }
    fail_at_the_end("cannot be replaced", reason);
  }
  unfinished_ = {};
  pending_ = false;
}

/// True if there was no target, and the nameless file has become the target.
bool OutputFile::link_to_target() const { return name_nameless_file(descriptor_, target_); }

/// The temporary file loses its name before the first byte is written: a reader that closes its end
/// may end this process.
void OutputFile::copy_to_target() {
  const int to = standard_output_ ? standard_output() : open_emptied(path_);
  if (to < 0) fail_to_write();
  if (standard_output_) std::cout.flush();
  const int from = std::exchange(descriptor_, -1);
  remove_temporary();
  rewind_file(from);
  std::array<char, 1 << 16> block;
  std::ptrdiff_t count = 0;
  bool written = true;
  while (written && (count = read_some(from, block.data(), block.size())) > 0) {
    written = write_all(to, block.data(), static_cast<std::size_t>(count));
  }
  const int reason = errno;
  close_file(from);
  if (!standard_output_) close_file(to);
  errno = reason;
  if (!written || count < 0) fail_to_write();
}

}  // namespace displayfile
