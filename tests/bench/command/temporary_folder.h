#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "clip/base/error.h"

namespace displayfile::bench {

/// A new folder, removed with all that is in it.
class TemporaryFolder {
 public:
  /// Throws Error if none can be made.
  TemporaryFolder() {
    const std::string letters(6, 'X');  // which mkdtemp replaces
    std::string name =
        (std::filesystem::temp_directory_path() / ("displayfile-" + letters)).string();
    if (::mkdtemp(name.data()) == nullptr) throw Error(name + ": no temporary folder can be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace displayfile::bench
