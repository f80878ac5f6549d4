#pragma once

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "programs/bench/report.h"

namespace displayfile::bench {

/// The finished cells and comparisons of a run, a line each, in a file beside its output, so that a
/// run that was interrupted is taken up again. The first line holds what the cells hold for:
/// another build, another processor or another effort starts anew.
class PartialFile {
 public:
  /// Reads what an earlier run left; lines that are not whole are left out. Throws Error if the
  /// file cannot be written.
  PartialFile(std::string path, const std::string& identity);

  /// What was finished before; null if it was not. `scene` is the scene's key.
  const Cell* find(const std::string& scene_key, const CellKey& key) const;
  /// The comparisons of a task (programs/bench/beside.h), which is told by `task`; likewise.
  const std::vector<Beside>* find_beside(const std::string& task) const;
  /// Throws Error if it cannot be written.
  void add(const std::string& scene_key, const Cell& cell);
  void add(const std::string& task, const std::vector<Beside>& beside);
  /// The run has come to its end: the file is not needed any more.
  void remove();

 private:
  struct Finished {
    std::string scene_key;
    Cell cell;
  };
  void write_line(const std::string& line);

  std::string path_;
  std::ofstream out_;
  // By an earlier run.
  std::vector<Finished> finished_;
  std::map<std::string, std::vector<Beside>> beside_;  // by their tasks
};

}  // namespace displayfile::bench
