#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace displayfile {

/// The files that pages are made of: those of programs/page, the gallery among them, and those of
/// the WebAssembly package (interp/web), which other builds than the command's make.
class PageFiles {
 public:
  /// As they were installed, or in the folders of the builds; `package` is where the WebAssembly
  /// package is, if it is not empty.
  explicit PageFiles(const std::filesystem::path& package = {});

  /// A file's text. Throws Error, with all places where it could have been, if it is not there.
  std::string text(const std::string& name) const;
  /// The paths of the gallery's drawing programs, by name.
  std::vector<std::filesystem::path> gallery() const;

 private:
  std::vector<std::filesystem::path> folders_;
};

}  // namespace displayfile
