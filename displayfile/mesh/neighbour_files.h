#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

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

/// Decodes a part of a URI: %20 is a blank (RFC 3986, section 2.1). Nothing if a percent sign is
/// not followed by two hexadecimal digits, or by 00, which no file name holds.
std::optional<std::string> percent_decoded(std::string_view text);

}  // namespace displayfile
