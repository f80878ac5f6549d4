#include "clip/base/on_disk.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace displayfile {

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

}  // namespace displayfile
