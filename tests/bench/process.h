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

/// What a whole process took. The memory is at least this program's own, which is small.
struct ProcessCost {
  double wall, processor;  ///< seconds; all its threads together
  double peak_memory;      ///< bytes
};
/// Runs a program by its path and waits for it. Throws Error if it does not end with status 0.
ProcessCost cost_of(const std::vector<std::string>& arguments);

/// The middle value, of one or more.
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
