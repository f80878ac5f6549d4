#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace displayfile::bench {

/// What a finished process gave.
struct Finished {
  bool succeeded;      ///< it could be started, and ended with status 0
  std::string output;  ///< its standard output
};
/// Runs a program, found on the path unless its name has a slash, and waits for it. Its standard
/// error goes nowhere.
Finished run(const std::vector<std::string>& arguments);

/// The cost of a whole process. The memory is at least this program's own, which is small.
struct Cost {
  double wall, processor;  // seconds
  double peak_memory;      // bytes
};
/// Runs a program and waits for it. Throws Error unless it ends with status 0.
Cost cost_of(std::vector<std::string> arguments);

/// There is at least one value.
double median(std::vector<double> values);

/// A new folder, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();  ///< throws Error if there can be none
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace displayfile::bench
