#pragma once

#include <memory>
#include <optional>
#include <string>

#include "clip/base/shared_library.h"

namespace displayfile {

/// A ZIP archive, read by minizip, with which the import library is linked.
class ZipArchive {
 public:
  /// `library` is the import library, whose dependencies are loaded with it. Throws Error if it has
  /// no minizip, or the file is not an archive.
  ZipArchive(const SharedLibrary& library, const std::string& path);
  ZipArchive(ZipArchive&&) = delete;
  ~ZipArchive();

  /// The content of the file of this name, in either case; nothing if there is none. Throws Error
  /// if it is damaged.
  std::optional<std::string> content(const std::string& name) const;

 private:
  struct Library;

  const std::string path_;
  std::unique_ptr<const Library> library_;
  void* archive_ = nullptr;
};

}  // namespace displayfile
