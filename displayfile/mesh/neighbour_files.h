#pragma once

#include <filesystem>
#include <string>

namespace displayfile {

/// The files that reading a mesh may open: its own, and those in its folder and below. Links are
/// resolved first: a link out of the folder is not a neighbour, but the mesh's own file may be a
/// link to anywhere.
class NeighbourFiles {
 public:
  /// Relative paths start at the working folder. Throws Error if the mesh's folder does not exist.
  explicit NeighbourFiles(const std::string& mesh);

  /// True for a regular file that may be opened.
  bool allows(const std::string& path) const;
  /// With links resolved.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path mesh_, folder_;  // without links
};

}  // namespace displayfile
