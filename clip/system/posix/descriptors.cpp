#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <initializer_list>

#include "clip/system/descriptors.h"

namespace displayfile {

namespace {

/// A path by which a file without a name can be opened.
std::string path_of(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

}  // namespace

int create_file(const std::string& path) {
  return ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);  // less umask
}

int create_nameless_file([[maybe_unused]] const std::filesystem::path& folder,
                         [[maybe_unused]] std::string& path) {
#if defined(O_TMPFILE)
  const int descriptor =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0666);
  if (descriptor < 0) return -1;
  path = path_of(descriptor);
  if (::access(path.c_str(), F_OK) == 0) return descriptor;
  ::close(descriptor);
#endif
  return -1;
}

bool name_nameless_file(int descriptor, const std::string& name) {
  return ::linkat(AT_FDCWD, path_of(descriptor).c_str(), AT_FDCWD, name.c_str(),
                  AT_SYMLINK_FOLLOW) == 0;
}

int open_emptied(const std::string& path) {
  return ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
}

int standard_output() { return STDOUT_FILENO; }

void close_file(int descriptor) { ::close(descriptor); }

bool rename_file(const std::string& from, const std::string& to) {
  return ::rename(from.c_str(), to.c_str()) == 0;
}

bool may_write(const std::string& path) {
  return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

bool can_write(int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags >= 0 && (flags & O_ACCMODE) == O_RDONLY) errno = EBADF;
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

void set_permissions(int descriptor, std::filesystem::perms permissions) {
  ::fchmod(descriptor, static_cast<mode_t>(permissions));
}

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

std::ptrdiff_t read_some(int descriptor, char* bytes, std::size_t count) {
  return ::read(descriptor, bytes, count);
}

void rewind_file(int descriptor) { ::lseek(descriptor, 0, SEEK_SET); }

bool put_on_disk(int descriptor) {
  while (::fsync(descriptor) != 0) {
    if (errno == EINTR) continue;
    return errno == EINVAL || errno == ENOTSUP || errno == EROFS || errno == ENOSYS;
  }
  return true;
}

bool put_names_on_disk(const std::filesystem::path& folder) {
  const char* const path = folder.empty() ? "." : folder.c_str();
  const int descriptor = ::open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return true;
  const bool is_there = put_on_disk(descriptor);
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return is_there;
}

int hold_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  return descriptor < 0 ? kNotHeld : descriptor;
}

void release_folder(int held) { ::close(held); }

void remove_empty_folder(int held, const std::filesystem::path& path) {
  ::unlinkat(held == kNotHeld ? AT_FDCWD : held, path.c_str(), AT_REMOVEDIR);
}

bool remove_path(const char* path) noexcept { return ::unlink(path) == 0 || ::rmdir(path) == 0; }

void keep_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    // Opens the lowest free descriptor, which is this one, in the direction in which it is never
    // used.
    if (::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

bool errors_are_on_terminal() { return ::isatty(STDERR_FILENO) == 1; }

}  // namespace displayfile
