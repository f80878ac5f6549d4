#include "clip/system/folders.h"

#include <fcntl.h>
#include <unistd.h>

namespace displayfile {

int hold_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  return descriptor < 0 ? kNotHeld : descriptor;
}

void release_folder(int held) { ::close(held); }

void remove_empty_folder(int held, const std::filesystem::path& path) {
  ::unlinkat(held == kNotHeld ? AT_FDCWD : held, path.c_str(), AT_REMOVEDIR);
}

bool remove_path(const char* path) noexcept { return ::unlink(path) == 0 || ::rmdir(path) == 0; }

}  // namespace displayfile
