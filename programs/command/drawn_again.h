#pragma once

#include <filesystem>
#include <string>

#include "programs/inputs/made_folders.h"

namespace displayfile {

/// Outputs drawn again, into a folder of their own, and compared with the files that are there:
/// `displayfile draw --check`. The folder is removed at the end.
class DrawnAgain {
 public:
  /// Throws Error if there is no folder for temporary files.
  DrawnAgain();
  ~DrawnAgain();
  DrawnAgain(const DrawnAgain&) = delete;
  DrawnAgain& operator=(const DrawnAgain&) = delete;

  /// Where the k-th picture's file is drawn; empty if it has none.
  std::filesystem::path place(std::size_t k, const std::filesystem::path& file) const;

  /// How the file that is there differs from the drawn one, or that it is missing; empty if it does
  /// not differ. Files with the same pixels or values are the same, whatever their bytes. Removes
  /// the drawn file.
  std::string difference(const std::filesystem::path& file,
                         const std::filesystem::path& drawn) const;

 private:
  std::filesystem::path folder_;
  MadeFolders made_;
};

}  // namespace displayfile
