#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <vector>

#include "clip/base/unfinished_path.h"

namespace displayfile {

/// Folders that outputs need. Those in which nothing is at the end are removed again, wherever the
/// folder that they are in has been moved meanwhile.
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
  /// A folder, by its path from another that is held open, or from where the process is.
  struct Made {
    int from;
    std::filesystem::path path;
  };
  /// A folder held open; kNotHeld if it cannot be, or many are.
  int held(const std::filesystem::path& folder);

  std::mutex one_at_a_time_;
  std::vector<Made> made_;                  // each after its parent
  std::vector<UnfinishedPath> unfinished_;  // of the same
  std::map<std::filesystem::path, int> held_;
};

}  // namespace displayfile
