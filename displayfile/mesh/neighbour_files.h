#pragma once

#include <filesystem>
#include <string>

namespace displayfile {

/// The files that reading a mesh may open: the mesh's own, and those in its folder and below it.
/// Links are followed first: one that leads out of the folder is not a neighbour, but the mesh's
/// own file may be a link to anywhere.
class NeighbourFiles {
 public:
  /// Relative paths begin at the folder in which the process works. Throws Error if the mesh's
  /// folder is not there.
  explicit NeighbourFiles(const std::string& mesh);

  /// True for a regular file that may be opened.
  bool allows(const std::string& path) const;
  /// With its links followed.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path mesh_, folder_;  // without links
};

}  // namespace displayfile
