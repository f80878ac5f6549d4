#include <fcntl.h>
#include <io.h>
#include <share.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <initializer_list>
#include <system_error>

#include "clip/system/descriptors.h"
#include "clip/system/windows/windows.h"

namespace displayfile {

namespace {

/// Sets errno to C's equivalent of the system's error.
int failed_by_system() {
  switch (::GetLastError()) {
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS: errno = EEXIST; break;
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND: errno = ENOENT; break;
    case ERROR_DISK_FULL: errno = ENOSPC; break;
    case ERROR_INVALID_NAME: errno = EINVAL; break;
    default: errno = EACCES;
  }
  return -1;
}

}  // namespace

/// Uses the system's own function, so that an open file can be removed or renamed.
int create_file(const std::string& path) {
  const HANDLE file =
      ::CreateFileW(std::filesystem::path(path).c_str(), GENERIC_READ | GENERIC_WRITE,
                    FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, CREATE_NEW,
                    FILE_ATTRIBUTE_NORMAL, nullptr);
  if (file == INVALID_HANDLE_VALUE) return failed_by_system();
  return ::_open_osfhandle(reinterpret_cast<std::intptr_t>(file), _O_BINARY | _O_NOINHERIT);
}

int create_nameless_file(const std::filesystem::path& /*folder*/, std::string& /*path*/) {
  return -1;
}

bool name_nameless_file(int /*descriptor*/, const std::string& /*name*/) {
  errno = ENOSYS;
  return false;
}

int open_emptied(const std::string& path) {
  return ::_wopen(std::filesystem::path(path).c_str(),
                  _O_WRONLY | _O_TRUNC | _O_BINARY | _O_NOINHERIT);
}

int standard_output() {
  constexpr int kStandardOutput = 1;
  ::_setmode(kStandardOutput, _O_BINARY);
  return kStandardOutput;
}

void close_file(int descriptor) { ::_close(descriptor); }

bool rename_file(const std::string& from, const std::string& to) {
  if (::MoveFileExW(std::filesystem::path(from).c_str(), std::filesystem::path(to).c_str(),
                    MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0) {
    return true;
  }
  failed_by_system();
  return false;
}

bool may_write(const std::string& path) {
  constexpr int kToWrite = 2;
  return ::_waccess(std::filesystem::path(path).c_str(), kToWrite) == 0;
}

/// The C library cannot report how a descriptor is open, but writing 0 bytes shows it. The null
/// handle of a program without a console is not a descriptor.
bool can_write(int descriptor) {
  const auto file = reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor));
  DWORD written = 0;
  if (file == INVALID_HANDLE_VALUE || ::WriteFile(file, "", 0, &written, nullptr) == 0) {
    errno = EBADF;
    return false;
  }
  return true;
}

/// Files inherit the permissions of their folder.
void set_permissions(int /*descriptor*/, std::filesystem::perms /*permissions*/) {}

bool write_all(int descriptor, const char* bytes, std::size_t count) {
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 20;
  while (count > 0) {
    const int written =
        ::_write(descriptor, bytes, static_cast<unsigned>(std::min(count, kMostAtOnce)));
    if (written < 0) return false;
    if (written == 0) {  // the result on a full disk
      errno = ENOSPC;
      return false;
    }
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

std::ptrdiff_t read_some(int descriptor, char* bytes, std::size_t count) {
  constexpr std::size_t kMostAtOnce = std::size_t{1} << 20;
  return ::_read(descriptor, bytes, static_cast<unsigned>(std::min(count, kMostAtOnce)));
}

void rewind_file(int descriptor) { ::_lseeki64(descriptor, 0, SEEK_SET); }

bool put_on_disk(int descriptor) { return ::_commit(descriptor) == 0; }

/// The file system's journal keeps names.
bool put_names_on_disk(const std::filesystem::path& /*folder*/) { return true; }

int hold_folder(const std::filesystem::path& /*folder*/) { return kNotHeld; }

void release_folder(int /*held*/) {}

void remove_empty_folder(int /*held*/, const std::filesystem::path& path) {
  ::RemoveDirectoryW(path.c_str());  // fails unless the folder is empty
}

/// A stopped program's handler runs on an ordinary thread here.
bool remove_path(const char* path) noexcept {
  try {
    std::error_code error;
    return std::filesystem::remove(path, error);
  } catch (...) {
    return false;  // out of memory
  }
}

/// The C library gives descriptors 0 to 2 to no other files.
void keep_standard_descriptors() {
  for (const int descriptor : {0, 1, 2}) {
    if (::_get_osfhandle(descriptor) >= 0) ::_setmode(descriptor, _O_BINARY);
  }
}

/// There may be a console, but not every console supports writing over a line.
bool errors_are_on_terminal() { return false; }

}  // namespace displayfile
