#include "clip/system/folders.h"

#include <system_error>

#include "clip/system/windows/windows.h"

namespace displayfile {

int hold_folder(const std::filesystem::path& /*folder*/) { return kNotHeld; }

void release_folder(int /*held*/) {}

void remove_empty_folder(int /*held*/, const std::filesystem::path& path) {
  ::RemoveDirectoryW(path.c_str());  // not if anything is in it
}

/// The handler of a stopped program is an ordinary thread here.
bool remove_path(const char* path) noexcept {
  try {
    std::error_code error;
    return std::filesystem::remove(path, error);
  } catch (...) {
    return false;  // no memory for the path
  }
}

}  // namespace displayfile
