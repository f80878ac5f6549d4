#pragma once

#include <filesystem>
#include <mutex>
#include <vector>

#include "displayfile/unfinished_path.h"

namespace displayfile {

/// Folders that outputs need. Those in which nothing is at the end are removed again.
class MadeFolders {
 public:
  MadeFolders() = default;
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

  /// Makes the file's folder, and those above it, unless they are there. Several threads may call
  /// it at a time. Throws Error, naming the folder, if it cannot be made.
  void make_for(const std::filesystem::path& file);

 private:
  std::mutex one_at_a_time_;
  std::vector<std::filesystem::path> made_;  // each after the one that it is in
  std::vector<UnfinishedPath> unfinished_;   // of the same
};

}  // namespace displayfile
