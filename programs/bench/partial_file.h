#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// The finished cells of a run, a line each, in a file beside its output, so that a run that was
/// interrupted is taken up again. The first line holds what the cells hold for: another build,
/// another processor or another effort starts anew.
class PartialFile {
 public:
  /// Reads what an earlier run left; lines that are not whole are left out. Throws Error if the
  /// file cannot be written.
  PartialFile(std::string path, const std::string& identity);

  /// What was finished before; null if it was not. `scene` is the scene's key.
  const Cell* find(const std::string& scene_key, const CellKey& key) const;
  /// Throws Error if it cannot be written.
  void add(const std::string& scene_key, const Cell& cell);
  /// The run has come to its end: the file is not needed any more.
  void remove();

  std::size_t read_from_before() const { return finished_.size(); }

 private:
  struct Finished {
    std::string scene_key;
    Cell cell;
  };
  void write_line(const std::string& line);

  std::string path_;
  std::ofstream out_;
  std::vector<Finished> finished_;  // by an earlier run
};

}  // namespace displayfile::bench
