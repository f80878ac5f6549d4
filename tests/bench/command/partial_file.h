#pragma once

#include <fstream>
#include <map>
#include <string>

#include "tests/bench/command/report.h"

namespace displayfile::bench {

/// The finished figures of a run, a line each, in a file beside its output, so that an interrupted
/// run can be resumed. The first line identifies the conditions: another build, another processor
/// or another effort starts anew.
class PartialFile {
 public:
  /// Reads the figures of an earlier run; incomplete lines are left out. Throws Error if the file
  /// cannot be written, as add does.
  PartialFile(std::string path, const std::string& identity);

  /// The figures finished before under that key; null if there are none.
  const Json* find(const std::string& key) const;
  void add(const std::string& key, const Json& figures);
  /// The run has come to its end: the file is not needed any more.
  void remove();

 private:
  void write_line(const Json& line);

  std::string path_;
  std::ofstream out_;
  std::map<std::string, Json> finished_;  // by an earlier run
};

}  // namespace displayfile::bench
